// Little-endian binary files: rows of float64 (x, y; or x, y, r) come in; ids (int32) and distances
// (float64) go out.
import { stat } from "node:fs/promises";
import { withFile } from "../files.mjs";
import { joinSections } from "./join.mjs";

export const unit = "points";

/** Ranges of a file for jobs of this many points. */
export async function split(file, { perJob, columns: { length: width } }) {
  const { size } = await stat(file);
  const what = width === 2 ? "pairs" : "x, y, r triples";
  if (size % (8 * width) !== 0)
    throw new Error(`${file} has ${size} bytes, no whole number of ${what}`);
  const count = size / (8 * width);
  return Array.from({ length: Math.ceil(count / perJob) }, (_, k) => {
    const from = k * perJob;
    return { from, size: Math.min(perJob, count - from), width };
  });
}

/** The rows of a range, one after the other. */
export async function read(file, { from, size, width }) {
  const row = 8 * width;
  const bytes = await withFile(file, "r", (input) => input.readAll(row * size, row * from));
  return new Float64Array(bytes.buffer);
}

export function encode(ids, distances) {
  const bytes = (array) => new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
  return { "ids.i32": bytes(ids), ...(distances && { "distances.f64": bytes(distances) }) };
}

export const join = joinSections;
