// Little-endian binary files: float64 pairs x, y come in; ids (int32) and distances (float64) go
// out.
import { open, stat } from "node:fs/promises";
import { joinSections } from "./join.mjs";

export const unit = "points";
const kPair = 16; // bytes

/** Ranges of a file for jobs of this many points. */
export async function split(file, { perJob }) {
  const { size } = await stat(file);
  if (size % kPair !== 0) throw new Error(`${file} has ${size} bytes, no whole number of pairs`);
  const count = size / kPair;
  return Array.from({ length: Math.ceil(count / perJob) }, (_, k) => {
    const from = k * perJob;
    const size = Math.min(perJob, count - from);
    return { from, size };
  });
}

/** The points of a range as flat x, y pairs. */
export async function read(file, { from, size }) {
  const xy = new Float64Array(2 * size);
  const input = await open(file);
  try {
    const { bytesRead } = await input.read(
      new Uint8Array(xy.buffer),
      0,
      kPair * size,
      kPair * from,
    );
    if (bytesRead !== kPair * size) throw new Error(`${file} has become shorter`);
  } finally {
    await input.close();
  }
  return xy;
}

export function encode(ids, distances) {
  const bytes = (array) => new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
  return { "ids.i32": bytes(ids), ...(distances && { "distances.f64": bytes(distances) }) };
}

export const join = joinSections;
