// Queries of a diagram, of the plane or of the sphere.
import { ApolloniusError } from "../errors.js";
import {
  allocated,
  checkedChoice,
  checkedCount,
  checkedDistances,
  checkedNumbers,
  checkNumber,
  checkOptions,
  optionsLast,
} from "./arguments.js";
import {
  checkedFilter,
  filterOf,
  firstOf,
  type Found,
  listsThrough,
  passing,
  throughFilter,
  type Walk,
} from "./filters.js";
import type { Inner } from "./inner.js";
import { type AnyNative, runningModule } from "./native/module.js";
import { atPoint, checkTypes, ofItems } from "./space.js";
import type {
  FilterOptions,
  FindManyArguments,
  NearbyFilter,
  NearbyLists,
  NearbyManyOptions,
  NearbyOptions,
  PickArguments,
  PickOptions,
  WithinManyOptions,
} from "./types.js";

/** Without the distance where nobody asks for it: on the sphere it costs as much as the search. */
export function find(inner: Inner, x: number, y: number, options?: FilterOptions): number {
  if (options !== undefined) return nearest(inner, x, y, options)?.id ?? -1;
  return atPoint(inner, x, y, (native) => native.find(x, y));
}

export function nearest(inner: Inner, x: number, y: number, options?: FilterOptions): Found | null {
  checkTypes(inner, x, y);
  const filter = filterOf(options);
  if (filter !== undefined) return passing(walkFrom(inner, x, y, Infinity), filter, inner.filters);
  const found = atPoint(inner, x, y, (native) => native.nearest(x, y));
  return found.id === -1 ? null : found;
}

/** The site whose far side is the farthest. */
export function farthest(inner: Inner, x: number, y: number): Found | null {
  const found = atPoint(inner, x, y, (native) => native.farthest(x, y));
  return found.id === -1 ? null : found;
}

/** So few points are asked one by one sooner than their arrays are copied to the heap and back. */
const kFew = 16;

/** The nearest site of each point; fills in the distances, if there is an array. */
export function findAll(
  inner: Inner,
  numbers: ArrayLike<number>,
  distances?: Float64Array,
): Int32Array {
  const { native } = inner;
  const ids = allocated(() => new Int32Array(numbers.length / 2));
  try {
    if (distances === undefined && ids.length <= kFew)
      for (let k = 0; k < ids.length; ++k)
        ids[k] = native.find(numbers[2 * k] as number, numbers[2 * k + 1] as number);
    else native.findMany(numbers, ids, distances ?? null);
  } catch (error) {
    throw ofItems(error, inner, numbers, 2);
  }
  return ids;
}

export function findMany(
  inner: Inner,
  points: ArrayLike<number>,
  how: FindManyArguments,
): Int32Array {
  const numbers = checkedNumbers(inner.space.points, points, 2);
  const [distances, options] = optionsLast(how) as [Float64Array?, FilterOptions?];
  const filter = filterOf(options);
  const out = checkedDistances(distances, numbers.length / 2);
  if (filter === undefined) return findAll(inner, numbers, out);
  return throughFilter(inner, filter, numbers, distances, {
    all: findAll,
    one: (x, y, passes) => passing(walkFrom(inner, x, y, Infinity), passes, inner.filters),
  });
}

function walkFrom(inner: Inner, x: number, y: number, farthest: number): Walk {
  return atPoint(inner, x, y, (native) => native.nearestFirst(x, y, farthest)) as Walk;
}

const orInfinity = (given: unknown): unknown => (given === undefined ? Infinity : given);

function checkedMaxDistance(name: string, maxDistance: unknown): number {
  if (maxDistance !== Infinity) checkNumber(name, maxDistance);
  return maxDistance as number;
}

export function kNearest(
  inner: Inner,
  x: number,
  y: number,
  k: number,
  options: NearbyOptions | undefined,
): Uint32Array {
  checkTypes(inner, x, y);
  const most = checkedCount("k", k);
  checkOptions(options, "maxDistance", "filter");
  const farthest = checkedMaxDistance("options.maxDistance", orInfinity(options?.maxDistance));
  return nearby(inner, x, y, most, farthest, checkedFilter(options?.filter));
}

export function within(
  inner: Inner,
  x: number,
  y: number,
  distance: number,
  options: FilterOptions | undefined,
): Uint32Array {
  checkTypes(inner, x, y);
  const farthest = checkedMaxDistance("distance", distance);
  return nearby(inner, x, y, checkedCount("k", Infinity), farthest, filterOf(options));
}

export function kNearestMany(
  inner: Inner,
  points: ArrayLike<number>,
  k: number,
  options: NearbyManyOptions | undefined,
): NearbyLists {
  const most = checkedCount("k", k);
  checkOptions(options, "maxDistance", "filter", "distances");
  const farthest = checkedMaxDistance("options.maxDistance", orInfinity(options?.maxDistance));
  return nearbyMany(inner, points, most, farthest, options);
}

export function withinMany(
  inner: Inner,
  points: ArrayLike<number>,
  distance: number,
  options: WithinManyOptions | undefined,
): NearbyLists {
  const farthest = checkedMaxDistance("distance", distance);
  checkOptions(options, "filter", "distances");
  return nearbyMany(inner, points, checkedCount("k", Infinity), farthest, options);
}

function nearbyMany(
  inner: Inner,
  points: ArrayLike<number>,
  most: number,
  farthest: number,
  options: WithinManyOptions | undefined,
): NearbyLists {
  const numbers = checkedNumbers(inner.space.points, points, 2);
  const filter = checkedFilter(options?.filter);
  const isFar = checkedChoice("options.distances", options?.distances, [false, true]);
  try {
    if (filter !== undefined) {
      const walk = (x: number, y: number) => inner.native.nearestFirst(x, y, farthest) as Walk;
      return listsThrough(inner, filter, numbers, isFar, most, walk);
    }
    const { ids, starts, distances } = inner.native.kNearestMany(numbers, most, farthest, isFar);
    return isFar ? { ids, starts, distances } : { ids, starts };
  } catch (error) {
    throw ofItems(error, inner, numbers, 2);
  }
}

function nearby(
  inner: Inner,
  x: number,
  y: number,
  most: number,
  farthest: number,
  filter: NearbyFilter | undefined,
): Uint32Array {
  return filter === undefined
    ? atPoint(inner, x, y, (native) => native.kNearest(x, y, most, farthest))
    : firstOf(walkFrom(inner, x, y, farthest), most, filter, inner.filters);
}

// --- Under a pointer -----------------------------------------------------------------------------

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

export function pick(inner: Inner, x: number, y: number, how: PickArguments): number {
  checkTypes(inner, x, y);
  const picking = checkedPicking(how);
  const [farthest, top, filter] = picking;
  if (filter !== undefined) return pickThrough(inner, x, y, picking, filter)?.id ?? -1;
  return atPoint(inner, x, y, (native) => native.pick(x, y, farthest, runningModule().Top[top]));
}

export function pickMany(inner: Inner, points: ArrayLike<number>, how: PickArguments): Int32Array {
  const numbers = checkedNumbers(inner.space.points, points, 2);
  const picking = checkedPicking(how);
  const [, , filter] = picking;
  if (filter === undefined) return pickAll(inner, numbers, picking);
  return throughFilter(inner, filter, numbers, undefined, {
    all: (asked, some) => pickAll(asked, some, picking),
    one: (x, y, passes) => pickThrough(inner, x, y, picking, passes),
  });
}

function pickThrough(
  inner: Inner,
  x: number,
  y: number,
  [farthest, top]: Picking,
  filter: NearbyFilter,
): Found | null {
  const { native, filters } = inner;
  return passing(walkFrom(inner, x, y, farthest), filter, filters, (id, best) =>
    top === "last" ? id > best : native.site(id).r < native.site(best).r,
  );
}

/** What `pick` says of each point; most are in no circle, and the nearest site is the answer. */
function pickAll(inner: Inner, numbers: ArrayLike<number>, [farthest, top]: Picking): Int32Array {
  const distances = allocated(() => new Float64Array(numbers.length / 2));
  const ids = findAll(inner, numbers, distances);
  distances.forEach((distance, k) => {
    // Distances are rounded: where they are next to the limit, the exact search decides.
    if (!(distance > 0 && distance < farthest * 0.999))
      ids[k] = inner.native.pick(
        numbers[2 * k]!,
        numbers[2 * k + 1]!,
        farthest,
        runningModule().Top[top],
      );
  });
  return ids;
}

// --- For tests -----------------------------------------------------------------------------------

/** null, or the first broken invariant in words. */
export function validate(native: AnyNative): string | null {
  const { what, where, level } = native.validate();
  if (what === "") return null;
  return `${level === 0 ? "" : `level ${level}: `}${what} ${where}`;
}
