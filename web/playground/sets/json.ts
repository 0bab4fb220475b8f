// Circles in JSON: arrays x, y, r, name, objects, flat numbers, or features of GeoJSON, whose
// properties come before their places.
import { type Cells, type Column, columnAt, kColumns, type Table } from "./columns.js";

/** Anything that JSON can hold, to be looked into. */
type Json = { [key: string]: unknown };
const isJson = (value: unknown): value is Json => typeof value === "object" && value !== null;

export function tableOfJson(data: unknown): Table {
  const items = listIn(data);
  if (!Array.isArray(items)) throw new Error("expected an array of circles");
  const called: Table["called"] = {};
  // flat triples
  if (items.length > 0 && items.every((item) => typeof item === "number")) {
    if (items.length % 3 !== 0)
      throw new Error(`${items.length} numbers are no circles: x, y, r of each are three`);
    const rows = Array.from({ length: items.length / 3 }, (_, k) =>
      cellsOf(items.slice(3 * k, 3 * k + 3), k, called),
    );
    return { rows, called };
  }
  return { rows: items.map((item, k) => cellsOf(item, k, called)), called };
}

function listIn(data: unknown): unknown {
  if (Array.isArray(data) || !isJson(data)) return data;
  return data.features ?? data.circles ?? data.sites;
}

function cellsOf(item: unknown, k: number, called: Table["called"]): Cells {
  const at = `row ${k + 1}`;
  if (Array.isArray(item)) {
    const [x, y, r, name] = item;
    return { at, values: { x, y, r, name } };
  }
  // The id of a feature is no name.
  const { id: _, ...own } = isJson(item) ? item : {};
  const found: Json = { ...placeIn(own), ...own, ...propertiesIn(own) };
  const keys = Object.keys(found).filter((key) => found[key] !== undefined);
  const values: Partial<Record<Column, unknown>> = {};
  for (const column of kColumns) {
    const place = columnAt(column, keys);
    if (place < 0) continue;
    values[column] = found[keys[place]];
    called[column] ??= keys[place];
  }
  if (values.x === undefined && isJson(own.geometry))
    throw new Error(`${at}: a ${own.geometry.type} is no circle without the properties x, y and r`);
  return { at, values };
}

function placeIn({ geometry }: Json): Json {
  if (!isJson(geometry) || geometry.type !== "Point") return {};
  const place = geometry.coordinates;
  return Array.isArray(place) ? { x: place[0], y: place[1] } : {};
}

const propertiesIn = ({ properties }: Json): Json => (isJson(properties) ? properties : {});
