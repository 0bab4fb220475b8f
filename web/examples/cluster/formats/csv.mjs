// Comma-separated values: columns of numbers come in, id and distance go out, a line a point. A
// record is one line; blank lines are none.
import Papa from "papaparse";
import { joinSections } from "./join.mjs";
import { firstLine, splitLines, textOf } from "./lines.mjs";

export const unit = "MB";
const kTypicalLine = 32; // bytes, to guess how many lines a job gets

/** Ranges of whole lines for jobs of about this many points; the heading is in none. */
export async function split(file, { perJob, columns }) {
  const { at, start } = columnsOf(file, await firstLine(file), columns);
  const ranges = await splitLines(file, { start, bytes: kTypicalLine * perJob });
  return ranges.map((range) => ({ ...range, at }));
}

/** Where the columns are in a line, and where the first point is: after the heading, if any. */
function columnsOf(file, first, names) {
  const [cells = []] = Papa.parse(first.toString("utf8").trimEnd()).data;
  const at = names.map((name) => cells.findIndex((cell) => cell.trim() === name));
  if (!at.includes(-1)) return { at, start: first.length };
  if (Number.isNaN(Number(cells[0])))
    throw new Error(
      `${file}: no columns ${names.join(", ")} among ${cells.join(", ")}: see --columns`,
    );
  return { at: [...names.keys()], start: 0 };
}

/** The columns of a range, row after row. */
export async function read(file, { from, to, at }) {
  const text = await textOf(file, { from, to });
  const { data, errors } = Papa.parse(text, { skipEmptyLines: true });
  const [error] = errors.filter(({ code }) => code !== "UndetectableDelimiter");
  if (error) throw new Error(`${file}, after byte ${from}, row ${error.row}: ${error.message}`);
  const values = new Float64Array(at.length * data.length);
  data.forEach((cells, row) => {
    for (const [k, column] of at.entries()) {
      const cell = cells[column]?.trim();
      const value = cell ? Number(cell) : Number.NaN; // Number("") would be 0
      if (!Number.isFinite(value))
        throw new Error(`${file}, after byte ${from}, row ${row}: no number: ${cells.join()}`);
      values[at.length * row + k] = value;
    }
  });
  return values;
}

export function encode(ids, distances) {
  const rows = distances
    ? Array.from(ids, (id, k) => `${id},${distances[k]}\n`)
    : Array.from(ids, (id) => `${id}\n`);
  return { csv: Buffer.from(rows.join("")) };
}

export function join(out, parts, { distances }) {
  return joinSections(out, parts, { first: distances ? "id,distance\n" : "id\n" });
}
