// Comma-separated values, or ones with another delimiter: columns of numbers come in, id and
// distance go out, a line a point. A record is one line; blank lines are none. Whatever could be
// guessed from a job's own lines, and so differ between jobs, is settled by the first line.
import Papa from "papaparse";
import { joinSections } from "./join.mjs";
import { firstLine, splitLines, textOf } from "./lines.mjs";

export const unit = "MB";
const kTypicalLine = 32; // bytes, to guess how many lines a job gets
const kDelimiters = [",", "\t", ";", "|"];

/** Ranges of whole lines for jobs of about this many points; the heading is in none. */
export async function split(file, { perJob, columns }) {
  const { start, ...layout } = layoutOf(file, await firstLine(file), columns);
  const ranges = await splitLines(file, { start, bytes: kTypicalLine * perJob });
  return ranges.map((range) => ({ ...range, ...layout }));
}

const numberOf = (cell) => (cell?.trim() ? Number(cell) : Number.NaN); // Number("") would be 0

/**
 * The delimiter, where the columns are in a line, and where the first point is: after a heading
 * with all the names; or at the start, if the first cells are numbers.
 */
function layoutOf(file, first, names) {
  const line = first.toString("utf8").trimEnd();
  const ways = kDelimiters.map((delimiter) => {
    const [cells = []] = Papa.parse(line, { delimiter, newline: "\n" }).data;
    return { delimiter, cells };
  });
  for (const { delimiter, cells } of ways) {
    const at = names.map((name) => cells.findIndex((cell) => cell.trim() === name));
    if (!at.includes(-1)) return { delimiter, at, start: first.length };
  }
  for (const { delimiter, cells } of ways)
    if (names.every((_, k) => Number.isFinite(numberOf(cells[k]))))
      return { delimiter, at: [...names.keys()], start: 0 };
  const { cells } = ways.reduce((a, b) => (b.cells.length > a.cells.length ? b : a));
  throw new Error(
    `${file}: no columns ${names.join(", ")} among ${cells.join(", ")}: see --columns`,
  );
}

/** The columns of a range, row after row. */
export async function read(file, { from, to, at, delimiter }) {
  const text = (await textOf(file, { from, to })).replaceAll("\r\n", "\n");
  const { data, errors } = Papa.parse(text, { delimiter, newline: "\n", skipEmptyLines: true });
  const [error] = errors;
  if (error) throw new Error(`${file}, after byte ${from}, row ${error.row}: ${error.message}`);
  const values = new Float64Array(at.length * data.length);
  data.forEach((cells, row) => {
    for (const [k, column] of at.entries()) {
      const value = numberOf(cells[column]);
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
