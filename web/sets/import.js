// Circles from text or a file: CSV with or without names of columns, JSON, GeoJSON points, or a
// snapshot of this page. Says which row is wrong.
import { Diagram } from "apollonius-diagram";
import { dsvFormat } from "d3-dsv";
import { Sites } from "../model/sites.js";

/** @typedef {{ x: number, y: number, r: number, name?: string }} Row */

const kColumns = {
  x: /^(x|cx|lon|lng|long|longitude)$/i,
  y: /^(y|cy|lat|latitude)$/i,
  r: /^(r|radius|weight|size)$/i,
  name: /^(name|label|id|title)$/i,
};
const kNothing = new Float64Array(0);

/** @param {string} text @param {string} [title] */
export function sitesFromText(text, title = "Your data") {
  const trimmed = text.replace(/^\uFEFF/, "").trim();
  if (trimmed === "") throw new Error("there is no text");
  const rows = /^[[{]/.test(trimmed) ? rowsOfJson(JSON.parse(trimmed)) : rowsOfCsv(trimmed);
  return sitesFromRows(rows, title);
}

/** @param {Row[]} rows @param {string} title */
export function sitesFromRows(rows, title) {
  const xyr = new Float64Array(3 * rows.length);
  const labels = rows.map((row, k) => {
    for (const [n, name] of /** @type {const} */ (["x", "y", "r"]).entries()) {
      if (!Number.isFinite(row[name])) throw new Error(`row ${k + 1}: ${name} is no number`);
      xyr[3 * k + n] = row[name];
    }
    return row.name ? { name: row.name } : undefined;
  });
  return new Sites(xyr, { key: "data", title }, { labels, original: kNothing });
}

/** @param {Uint8Array} bytes from anyone: they are proved */
export function sitesFromSnapshot(bytes, title = "Snapshot") {
  const diagram = Diagram.fromBytes(bytes);
  const ids = diagram.ids();
  const xyr = new Float64Array(ids.length === 0 ? 0 : 3 * ids.at(-1) + 3);
  for (const id of ids) {
    const { x, y, r } = diagram.site(id);
    xyr.set([x, y, r], 3 * id);
  }
  return new Sites(xyr, { key: "data", title }, { diagram, original: kNothing });
}

/** @param {File} file */
export async function sitesFromFile(file) {
  if (/\.bin$/i.test(file.name))
    return sitesFromSnapshot(new Uint8Array(await file.arrayBuffer()), file.name);
  return sitesFromText(await file.text(), file.name);
}

/** A missing radius is 0. */
const numberOf = (value) =>
  value === undefined || value === null || value === "" ? 0 : Number(value);
const required = (value) =>
  value === undefined || value === null || String(value).trim() === "" ? Number.NaN : Number(value);

/** @param {string} text @returns {Row[]} */
function rowsOfCsv(text) {
  const [head] = text.split("\n", 1);
  const separator = ["\t", ";", ","].find((sign) => head.includes(sign)) ?? ",";
  // parseRows, not parse, which would make code from a string
  const rows = dsvFormat(separator)
    .parseRows(text)
    .filter((row) => row.some((cell) => cell.trim() !== "" && !cell.startsWith("#")));
  const isHead = rows[0].slice(0, 2).some((cell) => !Number.isFinite(required(cell)));
  const columns = isHead ? columnsOf(rows.shift()) : { x: 0, y: 1, r: 2, name: 3 };
  return rows.map((row) => ({
    x: required(row[columns.x]),
    y: required(row[columns.y]),
    r: numberOf(row[columns.r]),
    name: row[columns.name]?.trim(),
  }));
}

function columnsOf(names) {
  const at = (name) => names.findIndex((cell) => kColumns[name].test(cell.trim()));
  const columns = { x: at("x"), y: at("y"), r: at("r"), name: at("name") };
  if (columns.x < 0 || columns.y < 0) throw new Error("there are no columns x and y");
  return columns;
}

/** @returns {Row[]} */
function rowsOfJson(data) {
  const items = Array.isArray(data) ? data : (data.features ?? data.circles ?? data.sites);
  if (!Array.isArray(items)) throw new Error("expected an array of circles");
  // flat triples
  if (items.length > 0 && items.every((item) => typeof item === "number"))
    return Array.from({ length: Math.floor(items.length / 3) }, (_, k) => ({
      x: items[3 * k],
      y: items[3 * k + 1],
      r: items[3 * k + 2],
    }));
  return items.map((item) => {
    if (Array.isArray(item))
      return { x: required(item[0]), y: required(item[1]), r: numberOf(item[2]), name: item[3] };
    const [x, y] = item?.geometry?.coordinates ?? [];
    const found = { x, y, ...item?.properties, ...item };
    const value = (name) =>
      found[
        Object.keys(found).find(
          (key) => kColumns[name].test(key) && key !== "id" && found[key] !== undefined,
        )
      ];
    const name = value("name");
    return {
      x: required(value("x")),
      y: required(value("y")),
      r: numberOf(value("r")),
      name: name === undefined ? undefined : String(name),
    };
  });
}
