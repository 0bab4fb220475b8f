// Queries of a diagram, of the plane or of the sphere.
import { ApolloniusError } from "../errors.js";
import {
  allocated,
  checkedChoice,
  checkedCount,
  checkedNumbers,
  checkNumber,
  checkOptions,
  taken,
} from "./arguments.js";
import {
  checkedFilter,
  type Filter,
  firstOf,
  foundAmong,
  listsThrough,
  passing,
  throughFilter,
  type Walk,
} from "./filters.js";
import type { Inner } from "./inner.js";
import { atPoint, checkTypes, ofItems } from "./space.js";
import type {
  FilterOptions,
  FindOptions,
  FoundSite,
  KNearestManyOptions,
  NearbyLists,
  NearestSites,
  PickOptions,
  WithinManyOptions,
} from "./types.js";

// --- Options -------------------------------------------------------------------------------------

function checkedLimit(name: string, limit: unknown): number {
  if (limit !== Infinity) checkNumber(name, limit);
  return taken(limit as number);
}

/** The limit of checked options: Infinity unless they say otherwise. */
function limitOf(options: FindOptions | null | undefined): number {
  const limit = options?.maxDistance;
  return limit === undefined ? Infinity : checkedLimit("options.maxDistance", limit);
}

function checkedFindOptions(options: FindOptions | undefined): [number, Filter | undefined] {
  checkOptions(options, "maxDistance", "filter");
  return [limitOf(options), checkedFilter(options?.filter)];
}

export function checkedFilterOptions(options: FilterOptions | undefined): Filter | undefined {
  checkOptions(options, "filter");
  return checkedFilter(options?.filter);
}

// --- The nearest site ----------------------------------------------------------------------------

function walkFrom(inner: Inner, x: number, y: number, limit: number): Walk {
  return atPoint(inner, x, y, (native) => native.nearestFirst(x, y, limit)) as Walk;
}

/** Finds the site without its distance, which on the sphere costs as much as the search. */
export function find(inner: Inner, x: number, y: number, options: FindOptions | undefined): number {
  if (options === undefined) return atPoint(inner, x, y, (native) => native.find(x, y));
  checkTypes(inner, x, y);
  const [limit, filter] = checkedFindOptions(options);
  if (filter !== undefined)
    return passing(walkFrom(inner, x, y, limit), filter, inner.filters)?.id ?? -1;
  return limit === Infinity
    ? atPoint(inner, x, y, (native) => native.find(x, y))
    : atPoint(inner, x, y, (native) => native.findWithin(x, y, limit));
}

export function nearest(
  inner: Inner,
  x: number,
  y: number,
  options: FindOptions | undefined,
): FoundSite | null {
  checkTypes(inner, x, y);
  const [limit, filter] = checkedFindOptions(options);
  if (filter !== undefined) return passing(walkFrom(inner, x, y, limit), filter, inner.filters);
  const found = atPoint(inner, x, y, (native) => native.nearest(x, y, limit));
  return found.id === -1 ? null : found;
}

/** Up to this count, single calls beat copying the arrays to the heap and back. */
const kFew = 16;

/** Returns the nearest site of each point; fills in the distances, if there is an array. */
function findAll(
  inner: Inner,
  numbers: ArrayLike<number>,
  limit: number,
  distances?: Float64Array,
): Int32Array {
  const { native } = inner;
  const ids = allocated(() => new Int32Array(numbers.length / 2));
  try {
    if (distances === undefined && limit === Infinity && ids.length <= kFew)
      for (let k = 0; k < ids.length; ++k)
        ids[k] = native.find(numbers[2 * k] as number, numbers[2 * k + 1] as number);
    else native.findMany(numbers, limit, ids, distances ?? null);
  } catch (error) {
    throw ofItems(error, inner, numbers, 2);
  }
  return ids;
}

function nearestThrough(
  inner: Inner,
  numbers: ArrayLike<number>,
  limit: number,
  filter: Filter,
): NearestSites {
  return throughFilter(inner, filter, numbers, {
    all: (asked, some, distances) => findAll(asked, some, limit, distances),
    one: (x, y, passes) => passing(walkFrom(inner, x, y, limit), passes, inner.filters),
  });
}

export function findMany(
  inner: Inner,
  points: ArrayLike<number>,
  options: FindOptions | undefined,
): Int32Array {
  const numbers = checkedNumbers(inner.space.points, points, 2);
  const [limit, filter] = checkedFindOptions(options);
  return filter === undefined
    ? findAll(inner, numbers, limit)
    : nearestThrough(inner, numbers, limit, filter).ids;
}

export function nearestMany(
  inner: Inner,
  points: ArrayLike<number>,
  options: FindOptions | undefined,
): NearestSites {
  const numbers = checkedNumbers(inner.space.points, points, 2);
  const [limit, filter] = checkedFindOptions(options);
  if (filter !== undefined) return nearestThrough(inner, numbers, limit, filter);
  const distances = allocated(() => new Float64Array(numbers.length / 2));
  return { ids: findAll(inner, numbers, limit, distances), distances };
}

// --- The farthest site ---------------------------------------------------------------------------

/** Returns the site whose far side is the farthest. */
export function farthest(
  inner: Inner,
  x: number,
  y: number,
  options: FilterOptions | undefined,
): FoundSite | null {
  checkTypes(inner, x, y);
  const filter = checkedFilterOptions(options);
  const found = atPoint(inner, x, y, (native) =>
    filter === undefined
      ? native.farthest(x, y)
      : foundAmong(inner, filter, (some) => some.farthest(x, y)),
  );
  return found.id === -1 ? null : found;
}

// --- Several sites -------------------------------------------------------------------------------

export function kNearest(
  inner: Inner,
  x: number,
  y: number,
  k: number,
  options: FindOptions | undefined,
): Uint32Array {
  checkTypes(inner, x, y);
  const most = checkedCount("k", k);
  const [limit, filter] = checkedFindOptions(options);
  return nearby(inner, x, y, most, limit, filter);
}

export function within(
  inner: Inner,
  x: number,
  y: number,
  maxDistance: number,
  options: FilterOptions | undefined,
): Uint32Array {
  checkTypes(inner, x, y);
  const limit = checkedLimit("maxDistance", maxDistance);
  return nearby(inner, x, y, checkedCount("k", Infinity), limit, checkedFilterOptions(options));
}

function nearby(
  inner: Inner,
  x: number,
  y: number,
  most: number,
  limit: number,
  filter: Filter | undefined,
): Uint32Array {
  return filter === undefined
    ? atPoint(inner, x, y, (native) => native.kNearest(x, y, most, limit))
    : firstOf(walkFrom(inner, x, y, limit), most, filter, inner.filters);
}

export function kNearestMany(
  inner: Inner,
  points: ArrayLike<number>,
  k: number,
  options: KNearestManyOptions | undefined,
): NearbyLists {
  const most = checkedCount("k", k);
  checkOptions(options, "maxDistance", "filter", "distances");
  return nearbyMany(inner, points, most, limitOf(options), options);
}

export function withinMany(
  inner: Inner,
  points: ArrayLike<number>,
  maxDistance: number,
  options: WithinManyOptions | undefined,
): NearbyLists {
  const limit = checkedLimit("maxDistance", maxDistance);
  checkOptions(options, "filter", "distances");
  return nearbyMany(inner, points, checkedCount("k", Infinity), limit, options);
}

function nearbyMany(
  inner: Inner,
  points: ArrayLike<number>,
  most: number,
  limit: number,
  options: WithinManyOptions | undefined,
): NearbyLists {
  const numbers = checkedNumbers(inner.space.points, points, 2);
  const filter = checkedFilter(options?.filter);
  const isFar = checkedChoice("options.distances", options?.distances, [false, true]);
  try {
    if (filter !== undefined) {
      const walk = (x: number, y: number) => inner.native.nearestFirst(x, y, limit) as Walk;
      return listsThrough(inner, filter, numbers, isFar, most, walk);
    }
    const { ids, starts, distances } = inner.native.kNearestMany(numbers, most, limit, isFar);
    return isFar ? { ids, starts, distances } : { ids, starts };
  } catch (error) {
    throw ofItems(error, inner, numbers, 2);
  }
}

// --- Under a pointer -----------------------------------------------------------------------------

/** The largest distance, which circle is on top, and the filter. */
type Picking = [number, "smallest" | "last", Filter | undefined];

function checkedPickOptions(options: PickOptions | undefined): Picking {
  checkOptions(options, "maxDistance", "top", "filter");
  const limit = limitOf(options);
  if (limit < 0)
    throw new ApolloniusError(
      "out-of-range",
      `options.maxDistance is ${limit}, expected a distance from 0 on`,
    );
  const top = checkedChoice("options.top", options?.top, ["smallest", "last"]);
  return [limit, top, checkedFilter(options?.filter)];
}

export function pick(inner: Inner, x: number, y: number, options: PickOptions | undefined): number {
  checkTypes(inner, x, y);
  const picking = checkedPickOptions(options);
  const [limit, top, filter] = picking;
  if (filter !== undefined) return pickThrough(inner, x, y, picking, filter)?.id ?? -1;
  return atPoint(inner, x, y, (native) => native.pick(x, y, limit, top === "last"));
}

export function pickMany(
  inner: Inner,
  points: ArrayLike<number>,
  options: PickOptions | undefined,
): Int32Array {
  const numbers = checkedNumbers(inner.space.points, points, 2);
  const picking = checkedPickOptions(options);
  const [, , filter] = picking;
  if (filter === undefined) return pickAll(inner, numbers, picking);
  const found = throughFilter(inner, filter, numbers, {
    all: (asked, some) => pickAll(asked, some, picking),
    one: (x, y, passes) => pickThrough(inner, x, y, picking, passes),
  });
  return found.ids;
}

function pickThrough(
  inner: Inner,
  x: number,
  y: number,
  [limit, top]: Picking,
  filter: Filter,
): FoundSite | null {
  const { native, filters } = inner;
  return passing(walkFrom(inner, x, y, limit), filter, filters, (id, best) =>
    top === "last" ? id > best : native.site(id).r < native.site(best).r,
  );
}

/** Picks at each point. Most points are in no circle: for them the nearest site is the answer. */
function pickAll(inner: Inner, numbers: ArrayLike<number>, [limit, top]: Picking): Int32Array {
  const distances = allocated(() => new Float64Array(numbers.length / 2));
  const ids = findAll(inner, numbers, limit, distances);
  distances.forEach((distance, k) => {
    if (distance <= 0)
      ids[k] = inner.native.pick(numbers[2 * k]!, numbers[2 * k + 1]!, limit, top === "last");
  });
  return ids;
}
