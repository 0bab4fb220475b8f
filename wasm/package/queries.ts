// The calls of Diagram that ask: what they are given is checked, and an error names the culprit.
import {
  allocated,
  checkedChoice,
  checkedCount,
  checkedDistances,
  checkedNumbers,
  checkedNumbersOfBounds,
  checkNumber,
  checkSiteId,
  checkWholeNumber,
  described,
  disorderedBounds,
  isSiteId,
  checkOptions,
} from "./arguments.js";
import { ApolloniusError } from "./errors.js";
import {
  type NativeDiagram,
  type NearestFirst,
  runningModule,
  type SphericalNearestFirst,
} from "./module.js";
import { checkTypes, ofElements, ofNumbers, ofSite } from "./native_errors.js";
import type { FilterOptions, NearbyFilter, NearbyOptions, PickOptions } from "./types.js";

export function has(native: NativeDiagram, id: number): boolean {
  checkWholeNumber(id);
  return isSiteId(id) && native.has(id);
}

/** What `ask` says of a site; errors name it. */
export function ofOne<Answer>(
  native: NativeDiagram,
  id: number,
  ask: (native: NativeDiagram) => Answer,
): Answer {
  checkSiteId(id);
  try {
    return ask(native);
  } catch (error) {
    throw ofSite(error, id);
  }
}

/** What `ask` says of a point; errors name the coordinate. */
export function atPoint<Answer>(
  native: NativeDiagram,
  x: number,
  y: number,
  ask: (native: NativeDiagram) => Answer,
): Answer {
  checkTypes(x, y);
  try {
    return ask(native);
  } catch (error) {
    throw ofNumbers(error, x, y);
  }
}

export function nearest(
  native: NativeDiagram,
  x: number,
  y: number,
): { id: number; distance: number } | null {
  const found = atPoint(native, x, y, () => native.nearest(x, y));
  return found.id === -1 ? null : found;
}

/** So few points are asked one by one sooner than their arrays are copied to the heap and back. */
const kFew = 16;

export function findMany(
  native: NativeDiagram,
  xy: ArrayLike<number>,
  distances: Float64Array | undefined,
): Int32Array {
  const numbers = checkedNumbers("xy", xy, 2);
  const ids = allocated(() => new Int32Array(numbers.length / 2));
  const out = checkedDistances(distances, ids.length);
  try {
    if (out === undefined && ids.length <= kFew)
      for (let k = 0; k < ids.length; ++k)
        ids[k] = native.find(numbers[2 * k] as number, numbers[2 * k + 1] as number);
    else native.findMany(numbers, ids, out ?? null);
  } catch (error) {
    throw ofElements(error, "xy", numbers);
  }
  return ids;
}

/** How many filter callbacks are running: none may change the diagram. */
export interface Filters {
  running: number;
}

/** The first `most` sites of a walk that the filter lets through. Ends the walk. */
export function firstOf(
  walk: NearestFirst | SphericalNearestFirst,
  most: number,
  filter: NearbyFilter | undefined,
  filters: Filters,
): Uint32Array {
  const found: number[] = [];
  ++filters.running;
  try {
    while (found.length < most) {
      const id = walk.next();
      if (id === -1) break;
      if (filter === undefined || filter(id)) found.push(id);
    }
  } finally {
    --filters.running;
    walk.delete();
  }
  return allocated(() => Uint32Array.from(found));
}

export function checkedFilter(filter: unknown): NearbyFilter | undefined {
  if (filter === undefined || typeof filter === "function") return filter as NearbyFilter;
  throw new ApolloniusError(
    "bad-option",
    `options.filter is ${described(filter)}, expected a function of an id`,
  );
}

function walkFrom(native: NativeDiagram, x: number, y: number, farthest: number): NearestFirst {
  return atPoint(native, x, y, () => native.nearestFirst(x, y, farthest)) as NearestFirst;
}

export const orInfinity = (given: unknown): unknown => (given === undefined ? Infinity : given);

export function checkedMaxDistance(name: string, maxDistance: unknown): number {
  if (maxDistance !== Infinity) checkNumber(name, maxDistance);
  return maxDistance as number;
}

export function kNearest(
  native: NativeDiagram,
  filters: Filters,
  x: number,
  y: number,
  k: number,
  options?: NearbyOptions,
): Uint32Array {
  checkTypes(x, y);
  const most = checkedCount("k", k);
  checkOptions(options, "maxDistance", "filter");
  const farthest = checkedMaxDistance("options.maxDistance", orInfinity(options?.maxDistance));
  const filter = checkedFilter(options?.filter);
  return farthest === Infinity && filter === undefined
    ? atPoint(native, x, y, () => native.kNearest(x, y, most))
    : firstOf(walkFrom(native, x, y, farthest), most, filter, filters);
}

export function within(
  native: NativeDiagram,
  filters: Filters,
  x: number,
  y: number,
  distance: number,
  options?: FilterOptions,
): Uint32Array {
  checkTypes(x, y);
  checkedMaxDistance("distance", distance);
  checkOptions(options, "filter");
  const filter = checkedFilter(options?.filter);
  if (filter !== undefined)
    return firstOf(walkFrom(native, x, y, distance), Infinity, filter, filters);
  return atPoint(native, x, y, () =>
    distance === Infinity
      ? native.kNearest(x, y, checkedCount("k", Infinity))
      : native.within(x, y, distance),
  );
}

export function pick(
  native: NativeDiagram,
  x: number,
  y: number,
  maxDistance?: number,
  options?: PickOptions,
): number {
  checkTypes(x, y);
  const farthest = checkedMaxDistance("maxDistance", orInfinity(maxDistance));
  if (farthest < 0)
    throw new ApolloniusError(
      "out-of-range",
      `maxDistance is ${farthest}, expected a distance from 0 on`,
    );
  checkOptions(options, "top");
  const top = checkedChoice("options.top", options?.top, ["smallest", "last"]);
  return atPoint(native, x, y, () => native.pick(x, y, farthest, runningModule().Top[top]));
}

export function search(native: NativeDiagram, ...bounds: unknown[]): Uint32Array {
  // Infinity means no limit on that side: no centre is farther than 1e100.
  const limits = [-Infinity, -Infinity, Infinity, Infinity];
  const finite = bounds.map((value, k) =>
    value === limits[k] ? Math.sign(Number(value)) * 1e100 : value,
  );
  const [xmin, ymin, xmax, ymax] = checkedNumbersOfBounds(finite);
  if (xmin > xmax || ymin > ymax) throw disorderedBounds([xmin, ymin, xmax, ymax], "<=");
  return native.search(xmin, ymin, xmax, ymax);
}

/** null, or the first broken invariant in words. */
export function validate(native: Pick<NativeDiagram, "validate">): string | null {
  const { what, where, level } = native.validate();
  if (what === "") return null;
  return `${level === 0 ? "" : `level ${level}: `}${what} ${where}`;
}
