// Comma-separated values: two columns come in, id and distance go out, a line a point. A record is
// one line; blank lines are none.
import { open, stat } from "node:fs/promises";
import Papa from "papaparse";
import { joinSections } from "./join.mjs";

export const unit = "MB";
const kTypicalLine = 32; // bytes, to guess how many lines a job gets
const kLongestLine = 1 << 16;

/** Ranges of whole lines for jobs of about this many points; the heading is in none. */
export async function split(file, { perJob, columns = ["x", "y"] }) {
  const { size } = await stat(file);
  const input = await open(file);
  try {
    const { at, start } = columnsOf(await lineAt(input, 0), columns);
    const ranges = [];
    for (let from = start; from < size; ) {
      const guess = from + kTypicalLine * perJob;
      const to = guess >= size ? size : guess + (await lineAt(input, guess)).length;
      ranges.push({ from, to: Math.min(to, size), at, size: (to - from) / 1e6 });
      from = to;
    }
    return ranges;
  } finally {
    await input.close();
  }
}

/** The rest of the line at a place in a file, with its end. */
async function lineAt(input, place) {
  const { buffer, bytesRead } = await input.read(
    Buffer.alloc(kLongestLine),
    0,
    kLongestLine,
    place,
  );
  const end = buffer.subarray(0, bytesRead).indexOf("\n");
  if (end < 0 && bytesRead === kLongestLine) throw new Error(`the line at ${place} is very long`);
  return buffer.subarray(0, end < 0 ? bytesRead : end + 1);
}

/** Where x and y are in a line, and where the first point is: after the heading, if any. */
function columnsOf(first, names) {
  const [cells = []] = Papa.parse(first.toString("utf8").trimEnd()).data;
  const at = names.map((name) => cells.findIndex((cell) => cell.trim() === name));
  if (!at.includes(-1)) return { at, start: first.length };
  if (Number.isNaN(Number(cells[0])))
    throw new Error(`no columns ${names.join(", ")} among ${cells.join(", ")}: see --columns`);
  return { at: [0, 1], start: 0 };
}

/** The points of a range as flat x, y pairs. */
export async function read(file, { from, to, at }) {
  const bytes = Buffer.alloc(to - from);
  const input = await open(file);
  try {
    await input.read(bytes, 0, bytes.length, from);
  } finally {
    await input.close();
  }
  const { data, errors } = Papa.parse(bytes.toString("utf8"), { skipEmptyLines: true });
  const [error] = errors.filter(({ code }) => code !== "UndetectableDelimiter");
  if (error) throw new Error(`${file}, after byte ${from}, row ${error.row}: ${error.message}`);
  const xy = new Float64Array(2 * data.length);
  data.forEach((cells, row) => {
    for (const axis of [0, 1]) {
      const cell = cells[at[axis]]?.trim();
      const value = cell ? Number(cell) : Number.NaN; // Number("") would be 0
      if (!Number.isFinite(value))
        throw new Error(`${file}, after byte ${from}, row ${row}: no number: ${cells.join()}`);
      xy[2 * row + axis] = value;
    }
  });
  return xy;
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
