// The calls of Diagram that ask: what they are given is checked, and an error names the culprit.
import { ApolloniusError } from "../errors.js";
import {
  allocated,
  checkedChoice,
  checkedCount,
  checkedNumbers,
  checkedNumbersOfBounds,
  checkNumber,
  checkOptions,
  checkSiteId,
  checkWholeNumber,
  disorderedBounds,
  isSiteId,
  optionsLast,
} from "./arguments.js";
import {
  checkedFilter,
  filterOf,
  type Filters,
  findMany as findManyOf,
  firstOf,
  type Found,
  passing,
  throughFilter,
} from "./filters.js";
import { type NativeDiagram, type NearestFirst, runningModule } from "./native/module.js";
import { checkTypes, ofElements, ofNumbers, ofSite } from "./native/native_errors.js";
import type {
  FilterOptions,
  FindManyArguments,
  NearbyFilter,
  NearbyOptions,
  PickArguments,
  PickOptions,
} from "./types.js";

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

export function find(
  native: NativeDiagram,
  filters: Filters,
  x: number,
  y: number,
  options?: FilterOptions,
): number {
  if (options !== undefined) return nearest(native, filters, x, y, options)?.id ?? -1;
  return atPoint(native, x, y, () => native.find(x, y));
}

export function nearest(
  native: NativeDiagram,
  filters: Filters,
  x: number,
  y: number,
  options?: FilterOptions,
): Found | null {
  checkTypes(x, y);
  const filter = filterOf(options);
  if (filter !== undefined) return passing(walkFrom(native, x, y, Infinity), filter, filters);
  const found = atPoint(native, x, y, () => native.nearest(x, y));
  return found.id === -1 ? null : found;
}

/** So few points are asked one by one sooner than their arrays are copied to the heap and back. */
const kFew = 16;

/** The nearest site of each point; fills in the distances, if there is an array. */
function findAll(
  native: NativeDiagram,
  numbers: ArrayLike<number>,
  distances?: Float64Array,
): Int32Array {
  const ids = allocated(() => new Int32Array(numbers.length / 2));
  try {
    if (distances === undefined && ids.length <= kFew)
      for (let k = 0; k < ids.length; ++k)
        ids[k] = native.find(numbers[2 * k] as number, numbers[2 * k + 1] as number);
    else native.findMany(numbers, ids, distances ?? null);
  } catch (error) {
    throw ofElements(error, "xy", numbers);
  }
  return ids;
}

/** Of the sites that a filter lets through. */
const empty = () => runningModule().create("hierarchy");

export function findMany(
  native: NativeDiagram,
  filters: Filters,
  xy: ArrayLike<number>,
  how: FindManyArguments,
): Int32Array {
  return findManyOf(native, filters, checkedNumbers("xy", xy, 2), how, {
    all: findAll,
    one: (x, y, filter) => passing(walkFrom(native, x, y, Infinity), filter, filters),
    empty,
  });
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
    : firstOf(walkFrom(native, x, y, farthest), most, filter ?? (() => true), filters);
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
  const filter = filterOf(options);
  if (filter !== undefined)
    return firstOf(walkFrom(native, x, y, distance), Infinity, filter, filters);
  return atPoint(native, x, y, () =>
    distance === Infinity
      ? native.kNearest(x, y, checkedCount("k", Infinity))
      : native.within(x, y, distance),
  );
}

/** The largest distance, which circle is on top, and the filter. */
type Picking = [number, "smallest" | "last", NearbyFilter | undefined];

function checkedPicking(how: PickArguments): Picking {
  const [maxDistance, options] = optionsLast(how) as [number?, PickOptions?];
  const farthest = checkedMaxDistance("maxDistance", orInfinity(maxDistance));
  if (farthest < 0)
    throw new ApolloniusError(
      "out-of-range",
      `maxDistance is ${farthest}, expected a distance from 0 on`,
    );
  checkOptions(options, "top", "filter");
  const top = checkedChoice("options.top", options?.top, ["smallest", "last"]);
  return [farthest, top, checkedFilter(options?.filter)];
}

function pickThrough(
  native: NativeDiagram,
  filters: Filters,
  x: number,
  y: number,
  [farthest, top]: Picking,
  filter: NearbyFilter,
): Found | null {
  return passing(walkFrom(native, x, y, farthest), filter, filters, (id, other) => {
    const less = top === "last" ? 0 : native.site(id).r - native.site(other).r;
    return less === 0 ? id > other : less < 0;
  });
}

export function pick(
  native: NativeDiagram,
  filters: Filters,
  x: number,
  y: number,
  how: PickArguments,
): number {
  checkTypes(x, y);
  const picking = checkedPicking(how);
  const [farthest, top, filter] = picking;
  if (filter !== undefined) return pickThrough(native, filters, x, y, picking, filter)?.id ?? -1;
  return atPoint(native, x, y, () => native.pick(x, y, farthest, runningModule().Top[top]));
}

/** What `pick` says of each point; most are in no circle, and the nearest site is the answer. */
function pickAll(
  native: NativeDiagram,
  numbers: ArrayLike<number>,
  [farthest, top]: Picking,
): Int32Array {
  const distances = allocated(() => new Float64Array(numbers.length / 2));
  const ids = findAll(native, numbers, distances);
  distances.forEach((distance, k) => {
    // Distances are rounded: where they are next to the limit, the exact search decides.
    if (!(distance > 0 && distance < farthest * 0.999))
      ids[k] = native.pick(
        numbers[2 * k]!,
        numbers[2 * k + 1]!,
        farthest,
        runningModule().Top[top],
      );
  });
  return ids;
}

export function pickMany(
  native: NativeDiagram,
  filters: Filters,
  xy: ArrayLike<number>,
  how: PickArguments,
): Int32Array {
  const numbers = checkedNumbers("xy", xy, 2);
  const picking = checkedPicking(how);
  const [, , filter] = picking;
  if (filter === undefined) return pickAll(native, numbers, picking);
  return throughFilter(native, filters, filter, numbers, undefined, {
    all: (of, points) => pickAll(of, points, picking),
    one: (x, y, passes) => pickThrough(native, filters, x, y, picking, passes),
    empty,
  });
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
