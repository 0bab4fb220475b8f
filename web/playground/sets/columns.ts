// Columns of a table by their names, and their values as numbers: places, radii, names. An
// unreadable value is said with its row and column.

/** A circle as it was read. */
export type Row = { x: number; y: number; r: number; name?: string; detail?: string };

/** In order of preference, in small letters. */
const kNames = {
  x: ["x", "cx", "lon", "lng", "long", "longitude", "länge", "laenge"],
  y: ["y", "cy", "lat", "latitude", "breite"],
  r: ["r", "radius", "weight", "range", "reach", "distance"],
  area: ["value", "size", "area", "population", "pop", "people", "count", "amount", "total"],
  name: ["name", "label", "title", "city", "id"],
  detail: ["detail", "description"],
} as const;
export type Column = keyof typeof kNames;
export const kColumns = Object.keys(kNames) as Column[];

/** One row before it is read: where it is in the file, and what its columns hold. */
export type Cells = { at: string; values: Partial<Record<Column, unknown>> };
/** Rows, and what the file calls their columns. */
export type Table = { rows: Cells[]; called: Partial<Record<Column, string>> };
/** `about` says what was taken as the radius, if that is not plain. */
export type Circles = { rows: Row[]; about?: string };

const kLargest = 1e100;
const kShare = 0.15; // of the square around the centres that circles take, if only areas are known

/** "Radius (km)" is the radius. */
const plain = (name: string) =>
  name
    .trim()
    .toLowerCase()
    .replace(/\s*[([].*$/, "");

/** Which of these names is the column's, as its number; -1 for none. */
export function columnAt(column: Column, names: readonly string[]) {
  const all = names.map(plain);
  const name = kNames[column].find((wanted) => all.includes(wanted));
  return name === undefined ? -1 : all.indexOf(name);
}

const isMissing = (value: unknown) =>
  value === undefined || value === null || (typeof value === "string" && value.trim() === "");

/** Whether a cell of text, or a value of JSON, is a number. */
export const isNumber = (value: unknown) =>
  !isMissing(value) &&
  (typeof value === "number" || typeof value === "string") &&
  Number.isFinite(Number(value));

/** The circles of a table. */
export function circlesIn({ rows, called }: Table): Circles {
  const has = (column: Column) => rows.some(({ values }) => !isMissing(values[column]));
  const read = ({ at, values }: Cells, column: Column, ifMissing?: number) => {
    const value = values[column];
    const place = `${at}, column ${called[column] ?? column}`;
    if (isNumber(value)) return inRange(Number(value), place);
    if (!isMissing(value)) throw new Error(`${place}: “${shortened(value)}” is no number`);
    if (ifMissing === undefined) throw new Error(`${place}: there is no value`);
    return ifMissing;
  };
  const isByArea = !has("r") && has("area");
  const circles = rows.map((row): Row => {
    const { name, detail } = row.values;
    const size = isByArea ? read(row, "area", 0) : read(row, "r", 0);
    if (isByArea && size < 0)
      throw new Error(`${row.at}, column ${called.area}: an area is not negative, as ${size} is`);
    return {
      x: read(row, "x"),
      y: read(row, "y"),
      r: size,
      ...(isMissing(name) ? {} : { name: String(name).trim() }),
      ...(isMissing(detail) ? {} : { detail: String(detail).trim() }),
    };
  });
  if (isByArea) return byArea(circles, called.area ?? "area");
  const { r } = called;
  if (r && !["r", "radius"].includes(plain(r)))
    return { rows: circles, about: `Column “${r}” is taken as the radius.` };
  if (has("r") || circles.length === 0) return { rows: circles };
  return { rows: circles, about: "There is no column r or radius: all circles are points." };
}

/** Within it answers are exact: docs/API.md. */
function inRange(value: number, place: string) {
  if (Math.abs(value) <= kLargest) return value;
  throw new Error(`${place}: ${value} is out of range: sizes up to 1e100`);
}

const shortened = (value: unknown) => {
  const text = typeof value === "string" ? value.trim() : (JSON.stringify(value) ?? "");
  return text.length > 24 ? `${text.slice(0, 24)}…` : text;
};

/** Circles whose r is an area so far. */
function byArea(rows: Row[], column: string): Circles {
  const extent = (values: number[]) =>
    values.reduce((a, b) => Math.max(a, b), -Infinity) -
    values.reduce((a, b) => Math.min(a, b), Infinity);
  const side = Math.max(extent(rows.map(({ x }) => x)), extent(rows.map(({ y }) => y)));
  const total = rows.reduce((sum, { r }) => sum + r, 0);
  // Where all are in one place nothing says how large they should be: areas are as given.
  const perArea = side > 0 && total > 0 ? (kShare * side ** 2) / total : 1;
  return {
    rows: rows.map((row) => ({
      ...row,
      r: Math.sqrt((row.r * perArea) / Math.PI),
      detail: row.detail ?? `${column}: ${row.r}`,
    })),
    about: `The areas of the circles are in proportion to column “${column}”.`,
  };
}
