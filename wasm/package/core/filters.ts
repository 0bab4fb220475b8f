// Searches with the caller's filter: walks over the sites around a point, nearest first, that leave
// out the sites which do not pass the filter.
import { ApolloniusError } from "../errors.js";
import { allocated, described } from "./arguments.js";
import type { Filters, Inner } from "./inner.js";
import type { AnyNative, NearestFirst, SphericalNearestFirst } from "./native/module.js";
import type { FilterOptions, FoundSite, NearbyLists, NearestSites } from "./types.js";

export type Filter = NonNullable<FilterOptions["filter"]>;

export type Walk = NearestFirst | SphericalNearestFirst;

export function checkedFilter(filter: unknown): Filter | undefined {
  if (filter === undefined || typeof filter === "function") return filter as Filter;
  throw new ApolloniusError(
    "bad-option",
    `options.filter is ${described(filter)}, expected a function of an id`,
  );
}

/** Returns the answer of `ask`, which may call filters and other functions of the caller's. */
export function filtering<Answer>(filters: Filters, ask: () => Answer): Answer {
  ++filters.running;
  try {
    return ask();
  } finally {
    --filters.running;
  }
}

/** Returns the answer of `use`, which may call filters; then deletes the walk. */
function walking<Answer>(walk: Walk, filters: Filters, use: () => Answer): Answer {
  try {
    return filtering(filters, use);
  } finally {
    walk.delete();
  }
}

/** Takes the first `most` sites of a walk that pass the filter. Ends the walk. */
function takeFirst(
  walk: Walk,
  most: number,
  filter: Filter,
  filters: Filters,
  take: (id: number) => void,
): void {
  walking(walk, filters, () => {
    for (let left = most; left > 0; ) {
      const id = walk.next();
      if (id === -1) break;
      if (!filter(id)) continue;
      take(id);
      --left;
    }
  });
}

/** Returns the first `most` sites of a walk that pass the filter. Ends the walk. */
export function firstOf(walk: Walk, most: number, filter: Filter, filters: Filters): Uint32Array {
  const found: number[] = [];
  takeFirst(walk, most, filter, filters, (id) => found.push(id));
  return allocated(() => Uint32Array.from(found));
}

/** Returns a filter that calls the given one only once for each site. */
function askedOnce(filter: Filter): Filter {
  const said: boolean[] = [];
  return (id) => (said[id] ??= Boolean(filter(id)));
}

/** Returns the list of firstOf() for each of many points. Calls the filter once for each site. */
export function listsThrough(
  { filters }: Inner,
  filter: Filter,
  given: ArrayLike<number>,
  isFar: boolean,
  most: number,
  walkFrom: (x: number, y: number) => Walk,
): NearbyLists {
  // a copy, as the filter may change the caller's array
  const points = allocated(() => new Float64Array(given));
  const starts = allocated(() => new Uint32Array(points.length / 2 + 1));
  const passes = askedOnce(filter);
  const found: number[] = [];
  const far: number[] = [];
  for (let k = 1; k < starts.length; ++k) {
    const walk = walkFrom(points[2 * k - 2]!, points[2 * k - 1]!);
    takeFirst(walk, most, passes, filters, (id) => {
      found.push(id);
      if (isFar) far.push(walk.distance());
    });
    starts[k] = found.length;
  }
  const ids = allocated(() => Uint32Array.from(found));
  return isFar
    ? { ids, starts, distances: allocated(() => Float64Array.from(far)) }
    : { ids, starts };
}

/**
 * Returns the first site of a walk that passes the filter; with `isAbove`, among those that contain
 * the point, the topmost. null if none passes. Ends the walk.
 */
export function passing(
  walk: Walk,
  filter: Filter,
  filters: Filters,
  isAbove?: (id: number, best: number) => boolean,
): FoundSite | null {
  return walking(walk, filters, () => {
    let best: FoundSite | null = null;
    for (let id = walk.next(); id !== -1; id = walk.next()) {
      const distance = walk.distance(); // its sign is exact
      if (best && distance > 0) break;
      if (!filter(id)) continue;
      if (!isAbove || distance > 0) return { id, distance };
      if (!best || isAbove(id, best.id)) best = { id, distance };
    }
    return best;
  });
}

/** Calls `use` with a diagram of the sites that pass, and with their ids in the given diagram. */
function amongPassing<Native extends AnyNative, Answer>(
  inner: Inner<Native>,
  passes: Filter,
  use: (some: Inner<Native>, chosen: Uint32Array) => Answer,
): Answer {
  const { ids, xyr } = inner.native.sites();
  const chosen = ids.filter(passes);
  const some = inner.space.empty(inner.native) as Native;
  try {
    some.insertMany(
      allocated(() => xyr.filter((_, at) => passes(ids[Math.floor(at / 3)]!))),
      chosen.slice(),
    );
    return use({ ...inner, native: some }, chosen);
  } finally {
    some.delete();
  }
}

/** Asks a diagram of the sites that pass. Returns the answer with its id in the given diagram. */
export function foundAmong(
  inner: Inner,
  filter: Filter,
  ask: (native: AnyNative) => FoundSite,
): FoundSite {
  return filtering(inner.filters, () =>
    amongPassing(inner, askedOnce(filter), ({ native }, chosen) => {
      const { id, distance } = ask(native);
      return { id: chosen[id] ?? -1, distance };
    }),
  );
}

/** The two searches of a call about many points. An id of -1 means no site. */
interface Questions<Native extends AnyNative> {
  /** Answers at all points without a filter; fills in the distances, if there is an array. */
  all(of: Inner<Native>, points: ArrayLike<number>, distances?: Float64Array): Int32Array;
  /** Answers at one point with a filter. */
  one(x: number, y: number, filter: Filter): FoundSite | null;
}

/**
 * Returns the answers at many points with a filter, which is called once for each site. Where the
 * site that is found without the filter does not pass, a walk finds another one. When walks have
 * looked at as many sites as the diagram has, a diagram of the sites that pass is built, which
 * costs less than further walks may, and gives the other answers. So the total cost is at most a
 * small multiple of the cheaper way.
 */
export function throughFilter<Native extends AnyNative>(
  inner: Inner<Native>,
  filter: Filter,
  given: ArrayLike<number>,
  { all, one }: Questions<Native>,
): NearestSites {
  const { native } = inner;
  // a copy, as the filter may change the caller's array
  const points = allocated(() => new Float64Array(given));
  const distances = allocated(() => new Float64Array(points.length / 2));
  const ids = all(inner, points, distances);
  const passes = askedOnce(filter);
  let looks = native.size();
  filtering(inner.filters, () => {
    for (let k = 0; k < ids.length; ++k) {
      if (ids[k] === -1 || passes(ids[k]!)) continue;
      if (looks <= 0) {
        amongPassing(inner, passes, (some, chosen) => {
          const rest = all(some, points.subarray(2 * k), distances.subarray(k));
          ids.set(
            rest.map((place) => chosen[place] ?? -1),
            k,
          );
        });
        break;
      }
      const next = one(points[2 * k]!, points[2 * k + 1]!, (id) => {
        --looks;
        return passes(id);
      });
      ids[k] = next?.id ?? -1;
      distances[k] = next?.distance ?? Infinity;
    }
  });
  return { ids, distances };
}
