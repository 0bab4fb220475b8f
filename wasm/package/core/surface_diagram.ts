// The calls with places, sites and lists of them, which the diagrams of the plane and of the sphere
// have in common: each is declared once, with the names that its surface has for numbers, and
// written once.
import { DynamicDiagram } from "./dynamic_diagram.js";
import { insert, insertMany, update, updateMany } from "./edits.js";
import { innerOf } from "./inner.js";
import {
  farthest,
  find,
  findMany,
  kNearest,
  kNearestMany,
  nearest,
  nearestMany,
  pick,
  pickMany,
  within,
  withinMany,
} from "./queries.js";
import { ofOne } from "./space.js";
import type {
  FilterOptions,
  FindOptions,
  FoundSite,
  KNearestManyOptions,
  NearbyLists,
  NearestSites,
  PickOptions,
  RadiusOption,
  UpdateOptions,
  WithinManyOptions,
} from "./types.js";

/** The names of the numbers of a surface, and the types of its sites. */
export interface Surface {
  place: [x: number, y: number];
  places: [xy: ArrayLike<number>];
  sites: [xyr: ArrayLike<number>];
  site: object;
  listed: object;
}

/** The calls as they are declared: editors show the names of the surface. */
interface SurfaceCalls<S extends Surface> {
  // --- Sites -------------------------------------------------------------------------------------

  /**
   * Adds a site (paper, section 3) and returns its id: stable while the site lives; ids of removed
   * sites are used again. Without r it is a point. Duplicates and covered circles are legal: they
   * are hidden sites. Cost: one location and O(size of the change); on the sphere, once in n
   * insertions, and when the number of sites has doubled, that of building. Throws "not-finite",
   * "out-of-range".
   */
  insert(...args: [...place: S["place"], r?: number]): number;

  /**
   * Adds flat triples, two coordinates and r each, or with the option `r` pairs; all or none, much
   * faster than a loop; returns their ids in input order. Cost: expected O(m log n) for m sites, on
   * the sphere that of building as for `insert`. Throws as `insert`, and "bad-length" (no multiple
   * of 3, or of 2), "too-large" (more than 2^29 sites), "bad-option".
   */
  insertMany(...args: S["sites"]): Uint32Array;
  insertMany(...args: [...places: S["places"], options: RadiusOption & { r: number }]): Uint32Array;

  /**
   * Moves and/or resizes a site, which keeps its id; without r it keeps its radius or weight. Cost:
   * as remove and insert. Throws "unknown-site", "not-finite", "out-of-range".
   */
  update(...args: [id: number, ...place: S["place"], r?: number]): this;

  /**
   * Updates site ids[k] to the k-th triple, all or none; with `r: "keep"` to the k-th pair, and
   * each site keeps its radius or weight. Cost: as `update` for each, but no more than building
   * takes where many sites move far. Throws as `update`, and "bad-length" unless there is one
   * triple (pair) an id, "bad-option".
   */
  updateMany(...args: [ids: ArrayLike<number>, ...sites: S["sites"]]): this;
  updateMany(
    ...args: [
      ids: ArrayLike<number>,
      ...places: S["places"],
      options: UpdateOptions & { r: number | "keep" },
    ]
  ): this;

  /** Centre and radius (weight) of a site, exactly as given. O(1). Throws "unknown-site". */
  site(id: number): S["site"];

  // --- The nearest sites -------------------------------------------------------------------------

  /**
   * The id of the site that is nearest to a point, among those that the options let through; -1 if
   * no site is left. With a `filter`, hidden sites count, too. The plane's answer is exact, and
   * ties go to the larger r, then x, then y; the sphere's is the nearest to within 4e-16 radians.
   * Cost: one location (paper, section 4), with a filter as kNearest. Throws "not-finite",
   * "out-of-range", "bad-option".
   */
  find(...args: [...place: S["place"], options?: FindOptions]): number;

  /**
   * `find` with the (rounded) distance to the rim, |p - c| - r, negative inside the circle; null if
   * no site is found. Cost, errors: as find.
   */
  nearest(...args: [...place: S["place"], options?: FindOptions]): FoundSite | null;

  /**
   * `find` for flat pairs of coordinates; many of them much faster than in a loop. Cost: m
   * locations for m points; with a filter: `FilterOptions`. Throws as `find`, and "bad-length".
   */
  findMany(...args: [...places: S["places"], options?: FindOptions]): Int32Array;

  /** `nearest` for flat pairs of coordinates. Cost, errors: as findMany. */
  nearestMany(...args: [...places: S["places"], options?: FindOptions]): NearestSites;

  /**
   * The k nearest sites of a point, hidden ones too, nearest first, of those that the options let
   * through; all if there are fewer. In the plane the order is exact; ties go to the larger r, then
   * x, then y, identical circles ascend by id. Cost: one location and O(m log m), m the number of
   * neighbours of the sites looked at, whatever n is. Throws "not-finite", "out-of-range" (also for
   * a k that is no whole number from 0 on; Infinity means all), "bad-option".
   */
  kNearest(...args: [...place: S["place"], k: number, options?: FindOptions]): Uint32Array;

  /**
   * `kNearest` for many points, flat pairs of coordinates: one list a point, as rows of a sparse
   * matrix. With `distances: true` it has their distances. Cost: less than single calls, as points
   * are visited in the order of their places; with a filter as single calls. Throws as `kNearest`,
   * and "bad-length".
   */
  kNearestMany(
    ...args: [...places: S["places"], k: number, options: KNearestManyOptions & { distances: true }]
  ): Required<NearbyLists>;
  kNearestMany(
    ...args: [...places: S["places"], k: number, options?: KNearestManyOptions]
  ): NearbyLists;

  /**
   * All sites whose distance to a point is at most `maxDistance`, hidden ones too, nearest first:
   * with 0 every circle that contains the point, negative for circles that contain it that deep. In
   * the plane it is exact. Cost: as kNearest. Throws "not-finite", "out-of-range", "bad-option".
   */
  within(
    ...args: [...place: S["place"], maxDistance: number, options?: FilterOptions]
  ): Uint32Array;

  /** `within` for many points: lists as of `kNearestMany`. Cost: as that. Throws as `within`, and
   * "bad-length". */
  withinMany(
    ...args: [
      ...places: S["places"],
      maxDistance: number,
      options: WithinManyOptions & { distances: true },
    ]
  ): Required<NearbyLists>;
  withinMany(
    ...args: [...places: S["places"], maxDistance: number, options?: WithinManyOptions]
  ): NearbyLists;

  /**
   * The circle under a pointer. Of the circles that contain the point, rim included, it is the one
   * on top: the smallest (of equally large ones the nearest), or with `top: "last"` the one with
   * the largest id. If none contains the point, it is the nearest site within `maxDistance` (0 for
   * none), else -1. In the plane it is exact. Cost: one location and O(m log m), m the number of
   * neighbours of the circles that contain the point or are asked about. Throws "not-finite",
   * "out-of-range" (also for a negative `maxDistance`), "bad-option".
   */
  pick(...args: [...place: S["place"], options?: PickOptions]): number;

  /** `pick` for flat pairs of coordinates. Filter, cost, errors: as findMany, for `pick`. */
  pickMany(...args: [...places: S["places"], options?: PickOptions]): Int32Array;

  /**
   * The site whose far side is the farthest, with the largest |p - c| + r, and that (rounded)
   * distance: in the plane, a circle about the point with that radius holds all circles. null if
   * no site is left. The plane's answer is exact, and ties go to the larger r, then x, then y.
   * Cost: O(length of the hull), on the sphere one location; with a filter that of building. Throws
   * "not-finite", "out-of-range", "bad-option".
   */
  farthest(...args: [...place: S["place"], options?: FilterOptions]): FoundSite | null;
}

/** The calls as they are written. */
abstract class Written extends DynamicDiagram<object> implements SurfaceCalls<Surface> {
  insert(x: number, y: number, r: number = 0): number {
    return insert(innerOf(this, true), x, y, r);
  }

  insertMany(sites: ArrayLike<number>, options?: RadiusOption): Uint32Array {
    return insertMany(innerOf(this, true), sites, options);
  }

  update(id: number, x: number, y: number, r?: number): this {
    update(innerOf(this, true), id, x, y, r);
    return this;
  }

  updateMany(ids: ArrayLike<number>, sites: ArrayLike<number>, options?: UpdateOptions): this {
    updateMany(innerOf(this, true), ids, sites, options);
    return this;
  }

  site(id: number): object {
    return ofOne(innerOf(this).native, id, (native) => native.site(id));
  }

  find(x: number, y: number, options?: FindOptions): number {
    return find(innerOf(this), x, y, options);
  }

  nearest(x: number, y: number, options?: FindOptions): FoundSite | null {
    return nearest(innerOf(this), x, y, options);
  }

  findMany(places: ArrayLike<number>, options?: FindOptions): Int32Array {
    return findMany(innerOf(this), places, options);
  }

  nearestMany(places: ArrayLike<number>, options?: FindOptions): NearestSites {
    return nearestMany(innerOf(this), places, options);
  }

  kNearest(x: number, y: number, k: number, options?: FindOptions): Uint32Array {
    return kNearest(innerOf(this), x, y, k, options);
  }

  kNearestMany(
    places: ArrayLike<number>,
    k: number,
    options?: KNearestManyOptions,
  ): Required<NearbyLists> {
    return kNearestMany(innerOf(this), places, k, options) as Required<NearbyLists>;
  }

  within(x: number, y: number, maxDistance: number, options?: FilterOptions): Uint32Array {
    return within(innerOf(this), x, y, maxDistance, options);
  }

  withinMany(
    places: ArrayLike<number>,
    maxDistance: number,
    options?: WithinManyOptions,
  ): Required<NearbyLists> {
    return withinMany(innerOf(this), places, maxDistance, options) as Required<NearbyLists>;
  }

  pick(x: number, y: number, options?: PickOptions): number {
    return pick(innerOf(this), x, y, options);
  }

  pickMany(places: ArrayLike<number>, options?: PickOptions): Int32Array {
    return pickMany(innerOf(this), places, options);
  }

  farthest(x: number, y: number, options?: FilterOptions): FoundSite | null {
    return farthest(innerOf(this), x, y, options);
  }
}

/** A diagram of a surface. */
export type SurfaceDiagram<S extends Surface> = DynamicDiagram<S["listed"]> & SurfaceCalls<S>;
// Declarations of the package reach this one: it names no type of the module's.
export const SurfaceDiagram = Written as unknown as abstract new <S extends Surface>(
  native: object,
  space: object,
) => SurfaceDiagram<S>;
