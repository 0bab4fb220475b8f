// Circles from text or a file: CSV with or without names of columns, JSON, GeoJSON points, or a
// snapshot of this page. Says which row is wrong.
import { Diagram } from "apollonius-diagram";
import { dsvFormat } from "d3-dsv";
import { Sites } from "../model/sites.js";

export type Row = { x: number; y: number; r: number; name?: string };

const kColumns = {
  x: /^(x|cx|lon|lng|long|longitude)$/i,
  y: /^(y|cy|lat|latitude)$/i,
  r: /^(r|radius|weight|size)$/i,
  name: /^(name|label|id|title)$/i,
};
type Column = keyof typeof kColumns;
const kNothing = new Float64Array(0);

export function sitesFromText(text: string, title: string = "Your data") {
  const trimmed = text.replace(/^\uFEFF/, "").trim();
  if (trimmed === "") throw new Error("there is no text");
  const rows = /^[[{]/.test(trimmed) ? rowsOfJson(JSON.parse(trimmed)) : rowsOfCsv(trimmed);
  return sitesFromRows(rows, title);
}

export function sitesFromRows(rows: Row[], title: string) {
  const xyr = new Float64Array(3 * rows.length);
  const labels = rows.map((row, k) => {
    for (const [n, name] of (["x", "y", "r"] as const).entries()) {
      if (!Number.isFinite(row[name])) throw new Error(`row ${k + 1}: ${name} is no number`);
      xyr[3 * k + n] = row[name];
    }
    return row.name ? { name: row.name } : undefined;
  });
  return new Sites(xyr, { key: "data", title }, { labels, original: kNothing });
}

/** @param bytes from anyone: they are proved */
export function sitesFromSnapshot(bytes: Uint8Array, title = "Snapshot") {
  const diagram = Diagram.fromBytes(bytes);
  const ids = diagram.ids();
  const xyr = new Float64Array(ids.length === 0 ? 0 : 3 * ids[ids.length - 1] + 3);
  for (const id of ids) {
    const { x, y, r } = diagram.site(id);
    xyr.set([x, y, r], 3 * id);
  }
  return new Sites(xyr, { key: "data", title }, { diagram, original: kNothing });
}

export async function sitesFromFile(file: File) {
  if (/\.bin$/i.test(file.name))
    return sitesFromSnapshot(new Uint8Array(await file.arrayBuffer()), file.name);
  return sitesFromText(await file.text(), file.name);
}

/** A missing radius is 0. */
const numberOf = (value: unknown) =>
  value === undefined || value === null || value === "" ? 0 : Number(value);
const required = (value: unknown) =>
  value === undefined || value === null || String(value).trim() === "" ? Number.NaN : Number(value);

function rowsOfCsv(text: string): Row[] {
  const [head] = text.split("\n", 1);
  const separator = ["\t", ";", ","].find((sign) => head.includes(sign)) ?? ",";
  // parseRows, not parse, which would make code from a string
  const rows = dsvFormat(separator)
    .parseRows(text)
    .filter((row) => row.some((cell) => cell.trim() !== "" && !cell.startsWith("#")));
  const isHead = rows[0].slice(0, 2).some((cell) => !Number.isFinite(required(cell)));
  const columns = isHead ? columnsOf(rows[0]) : { x: 0, y: 1, r: 2, name: 3 };
  return rows.slice(isHead ? 1 : 0).map((row) => ({
    x: required(row[columns.x]),
    y: required(row[columns.y]),
    r: numberOf(row[columns.r]),
    name: row[columns.name]?.trim(),
  }));
}

function columnsOf(names: string[]) {
  const at = (name: Column) => names.findIndex((cell) => kColumns[name].test(cell.trim()));
  const columns = { x: at("x"), y: at("y"), r: at("r"), name: at("name") };
  if (columns.x < 0 || columns.y < 0) throw new Error("there are no columns x and y");
  return columns;
}

/** Anything that JSON can hold, to be looked into. */
type Json = { [key: string]: unknown };
const isJson = (value: unknown): value is Json => typeof value === "object" && value !== null;

function rowsOfJson(data: unknown): Row[] {
  const items = listIn(data);
  if (!Array.isArray(items)) throw new Error("expected an array of circles");
  // flat triples
  if (items.length > 0 && items.every((item) => typeof item === "number"))
    return Array.from({ length: Math.floor(items.length / 3) }, (_, k) => ({
      x: items[3 * k],
      y: items[3 * k + 1],
      r: items[3 * k + 2],
    }));
  return items.map(rowOf);
}

function listIn(data: unknown): unknown {
  if (Array.isArray(data) || !isJson(data)) return data;
  return data.features ?? data.circles ?? data.sites;
}

/** An array x, y, r, name; an object; or a feature of GeoJSON. */
function rowOf(item: unknown): Row {
  if (Array.isArray(item)) {
    const [x, y, r, name] = item;
    return { x: required(x), y: required(y), r: numberOf(r), name };
  }
  const found = isJson(item) ? { ...placeIn(item), ...propertiesIn(item), ...item } : {};
  const value = (name: Column) =>
    Object.entries(found).find(
      ([key, value]) => kColumns[name].test(key) && key !== "id" && value !== undefined,
    )?.[1];
  const name = value("name");
  return {
    x: required(value("x")),
    y: required(value("y")),
    r: numberOf(value("r")),
    name: name === undefined ? undefined : String(name),
  };
}

function placeIn({ geometry }: Json): Json {
  const place = isJson(geometry) ? geometry.coordinates : undefined;
  return Array.isArray(place) ? { x: place[0], y: place[1] } : {};
}

const propertiesIn = ({ properties }: Json): Json => (isJson(properties) ? properties : {});
