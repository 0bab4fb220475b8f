// Turns the library's arrays of a cell into the form that callers get.
import type { CellMeasures, CoverageArrays, RingArrays } from "../../../build/wasm/apollonius.mjs";
import { positionsOf } from "./geojson.js";
import type { CellRing, Measures } from "./types.js";

/** The rings of a cell, one after the other, and whether callers get them as flat arrays. */
export interface Rings extends RingArrays {
  isFlat: boolean;
}

/** Joins rings to one: it goes to each further ring and around it, then back the same way. */
export function joined({ isFlat, coordinates, starts }: Omit<Rings, "parts">): CellRing | null {
  if (starts.length < 2) return null;
  const ends = [...starts.subarray(0, -2).reverse()];
  const back = ends.flatMap((at) => [coordinates[2 * at]!, coordinates[2 * at + 1]!]);
  const ring = back.length === 0 ? coordinates : Float64Array.from([...coordinates, ...back]);
  return isFlat ? ring : positionsOf(ring);
}

/** Returns the ring of the k-th of several cells. */
export function ringOf(
  { coordinates, starts, parts, cells }: CoverageArrays,
  k: number,
  isFlat: boolean,
): CellRing {
  const [first, end] = [parts[cells[k]!]!, parts[cells[k + 1]!]!];
  const [from, to] = [starts[first]!, starts[end]!];
  if (!isFlat && end === first + 1) return positionsOf(coordinates, from, to);
  const ring = coordinates.slice(2 * from, 2 * to);
  if (end === first + 1) return ring;
  const own = starts.slice(first, end + 1).map((start) => start - from);
  return joined({ isFlat, coordinates: ring, starts: own })!;
}

export function partsOf({ isFlat, coordinates, starts, parts }: Rings): CellRing[][] | null {
  if (starts.length < 2) return null;
  const rings = Array.from(starts.subarray(1), (end, k): CellRing => {
    const ring = coordinates.slice(2 * (starts[k] as number), 2 * end);
    return isFlat ? ring : positionsOf(ring);
  });
  return Array.from(parts.subarray(1), (end, k) => rings.slice(parts[k], end));
}

export function measuresOf(measures: CellMeasures): Measures {
  const { area, centroidX, centroidY, perimeter, isEmpty } = measures;
  return { area, centroid: isEmpty ? null : [centroidX, centroidY], perimeter };
}
