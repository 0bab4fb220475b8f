// The calls of Diagram that ask: what they are given is checked, and an error names the culprit.
import {
  allocated,
  checkedCount,
  checkedDistances,
  checkedNumbers,
  checkNumber,
  checkSiteId,
  isSiteId,
} from "./arguments.js";
import type { NativeDiagram } from "./module.js";
import { checkTypes, ofElements, ofNumbers, ofSite } from "./status.js";
import type { Site } from "./types.js";

export function has(native: NativeDiagram, id: number): boolean {
  return isSiteId(id) && native.has(id);
}

/** What `ask` says of a site. */
function ofOne<Answer>(id: number, ask: () => Answer): Answer {
  checkSiteId(id);
  try {
    return ask();
  } catch (error) {
    throw ofSite(error, id);
  }
}

export function site(native: NativeDiagram, id: number): Site {
  return ofOne(id, () => native.site(id));
}

export function isHidden(native: NativeDiagram, id: number): boolean {
  return ofOne(id, () => native.isHidden(id));
}

export function coverOf(native: NativeDiagram, id: number): number {
  return ofOne(id, () => native.coverOf(id));
}

export function neighbors(native: NativeDiagram, id: number): Uint32Array {
  return ofOne(id, () => native.neighbors(id));
}

/** What `ask` says of a point. */
function atPoint<Answer>(x: number, y: number, ask: () => Answer): Answer {
  checkTypes(x, y);
  try {
    return ask();
  } catch (error) {
    throw ofNumbers(error, x, y);
  }
}

export function find(native: NativeDiagram, x: number, y: number): number {
  return atPoint(x, y, () => native.find(x, y));
}

export function nearest(
  native: NativeDiagram,
  x: number,
  y: number,
): { id: number; distance: number } | null {
  const found = atPoint(x, y, () => native.nearest(x, y));
  return found.id === -1 ? null : found;
}

export function findMany(
  native: NativeDiagram,
  xy: ArrayLike<number>,
  distances: Float64Array | undefined,
): Int32Array {
  const numbers = checkedNumbers("xy", xy, 2);
  const ids = allocated(() => new Int32Array(numbers.length / 2));
  const out = checkedDistances(distances, ids.length);
  try {
    native.findMany(numbers, ids, out ?? null);
  } catch (error) {
    throw ofElements(error, "xy", numbers);
  }
  return ids;
}

export function kNearest(native: NativeDiagram, x: number, y: number, k: number): Uint32Array {
  checkTypes(x, y);
  const count = checkedCount("k", k);
  return atPoint(x, y, () => native.kNearest(x, y, count));
}

export function within(native: NativeDiagram, x: number, y: number, distance: number): Uint32Array {
  checkTypes(x, y);
  checkNumber("distance", distance);
  return atPoint(x, y, () => native.within(x, y, distance));
}
