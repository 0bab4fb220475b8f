import { type Accessor, accessorsAndOptions, type Items } from "../core/accessors.js";
import { checkedBytes, checkOptions } from "../core/arguments.js";
import { buildOrDispose } from "../core/building.js";
import { DynamicDiagram } from "../core/dynamic_diagram.js";
import { insert, insertMany, update, updateMany } from "../core/edits.js";
import { fillOrDispose } from "../core/native/lifetime.js";
import { runningModule } from "../core/native/module.js";
import {
  farthest,
  find,
  findMany,
  kNearest,
  nearest,
  pick,
  pickMany,
  within,
} from "../core/queries.js";
import { ofOne } from "../core/space.js";
import type {
  FilterOptions,
  FindManyArguments,
  NearbyOptions,
  PickArguments,
} from "../core/types.js";
import type { ViewOptions } from "../shapes/types.js";
import { checkedRadius, placeReader, sphere, sphericalOf } from "./spherical_arguments.js";
import type {
  ListedSphericalSite,
  Spherical,
  SphericalBuildOptions,
  SphericalOptions,
  SphericalSite,
  SphericalSites,
  SphericalVertices,
} from "./spherical_types.js";
import { SphericalVoronoi } from "./spherical_voronoi.js";

/**
 * The additively weighted Voronoi diagram of the sphere, fully dynamic: for maps.
 *
 * A site has a centre in degrees, longitude first, and a weight r. The distance of a point to it
 * is the way along a great circle minus r, in the unit of the sphere's radius. Any longitude,
 * latitudes from -90 to 90, weights below half a great circle, negative ones too; only their
 * differences matter to the diagram. n is the number of sites, d the number of a site's neighbours.
 *
 * The graph is computed exactly, of sites that were rounded to some 1e-15 radians (6 nm on the
 * Earth; more beside a site that nearly hides another). The nearest site is the nearest to
 * within twice that. The same sites give the same bits in every engine.
 *
 * Every call that fails throws an ApolloniusError and leaves the diagram as it was; after `dispose`
 * every call throws "disposed". Every call that needs memory can throw "out-of-memory". Ids, hidden
 * sites and what is returned are as of `Diagram`.
 */
export class SphericalDiagram extends DynamicDiagram<ListedSphericalSite> {
  /**
   * A diagram of flat longitude, latitude, r triples; their ids are 0, 1, 2, … in input order.
   * Cost: expected O(n log n). Throws "not-finite", "out-of-range" (a latitude, weight or radius),
   * "bad-length" (no multiple of 3), "too-large" (more than 2^29 triples), "bad-option".
   */
  constructor(lonLatR?: ArrayLike<number>, options?: SphericalOptions) {
    checkOptions(options, "radius");
    super(runningModule().createSpherical(checkedRadius(options)), sphere);
    if (lonLatR !== undefined) fillOrDispose(this, () => this.insertMany(lonLatR));
  }

  /**
   * A diagram of any items, read by accessors (item, index, items); with two accessors, items are
   * points. Without accessors an item is an object {lon, lat, r}, an array [lon, lat, r] or a point
   * of GeoJSON, and `items` may be a FeatureCollection; a missing r is 0. Options come last. Ids
   * are 0, 1, 2, … in input order. Throws as the constructor, naming the item; "bad-option" if an
   * item without r has a `radius`, `size` or `weight`, which nothing would read.
   */
  static from<T>(
    items: Items<T>,
    lon: Accessor<T>,
    lat: Accessor<T>,
    r?: Accessor<T> | SphericalOptions,
    options?: SphericalOptions,
  ): SphericalDiagram;
  static from<T extends Spherical>(
    items: Items<T> | { readonly type: "FeatureCollection"; readonly features: Items<T> },
    options?: SphericalOptions,
  ): SphericalDiagram;
  static from(items: unknown, ...rest: unknown[]): SphericalDiagram {
    const [accessors, options] = accessorsAndOptions<unknown, SphericalOptions>(rest, "radius");
    const radius = checkedRadius(options);
    const reader = placeReader(items as Items<unknown>, accessors, radius);
    return new SphericalDiagram(reader.triples(0, reader.count), { radius });
  }

  /**
   * Builds the diagram of `from` in slices of some 8 ms on this thread, between which pages answer
   * and timers run. Not cut are the steps that `Diagram.fromAsync` names. Rejects as `from` throws;
   * with the reason of `options.signal` once that aborts; with what accessors or `onProgress`
   * throw. Then there is no diagram. Cost: about that of `from`.
   */
  static fromAsync<T>(
    items: Items<T>,
    lon: Accessor<T>,
    lat: Accessor<T>,
    r?: Accessor<T> | SphericalBuildOptions,
    options?: SphericalBuildOptions,
  ): Promise<SphericalDiagram>;
  static fromAsync<T extends Spherical>(
    items: Items<T> | { readonly type: "FeatureCollection"; readonly features: Items<T> },
    options?: SphericalBuildOptions,
  ): Promise<SphericalDiagram>;
  static async fromAsync(items: unknown, ...rest: unknown[]): Promise<SphericalDiagram> {
    const names = ["radius", "signal", "onProgress"];
    const [accessors, options] = accessorsAndOptions<unknown, SphericalBuildOptions>(
      rest,
      ...names,
    );
    const radius = checkedRadius(options);
    const reader = placeReader(items as Items<unknown>, accessors, radius);
    const diagram = new SphericalDiagram(undefined, { radius });
    await buildOrDispose(diagram, reader, options ?? {});
    return diagram;
  }

  /**
   * The diagram that `toBytes` saved, with its radius and ids. Throws "corrupt-snapshot",
   * "bad-length" (no Uint8Array). Cost: that of building.
   */
  static fromBytes(bytes: Uint8Array): SphericalDiagram {
    const diagram = new SphericalDiagram();
    fillOrDispose(diagram, () => {
      const { native, ballast } = sphericalOf(diagram);
      native.fromBytes(checkedBytes("bytes", bytes));
      ballast.carry(native.size());
    });
    return diagram;
  }

  // --- Sites -------------------------------------------------------------------------------------

  /** The sphere's radius. O(1). */
  get radius(): number {
    return sphericalOf(this).native.radius();
  }

  /**
   * Adds a site and returns its id. Cost: one location and O(size of the change); once in n
   * insertions, and when the number of sites has doubled, that of building. Throws "not-finite",
   * "out-of-range".
   */
  insert(lon: number, lat: number, r: number = 0): number {
    return insert(sphericalOf(this, true), lon, lat, r);
  }

  /**
   * Adds flat longitude, latitude, r triples, all or none; returns their ids in input order. Cost:
   * expected O(m log n) for m triples, and that of building as for `insert`. Throws as `insert`,
   * and "bad-length", "too-large".
   */
  insertMany(lonLatR: ArrayLike<number>): Uint32Array {
    return insertMany(sphericalOf(this, true), lonLatR);
  }

  /**
   * Moves and/or reweights a site, which keeps its id; without r it keeps its weight. Cost: as
   * remove and insert. Throws "unknown-site", "not-finite", "out-of-range".
   */
  update(id: number, lon: number, lat: number, r?: number): this {
    update(sphericalOf(this, true), id, lon, lat, r);
    return this;
  }

  /**
   * Updates site ids[k] to the k-th longitude, latitude, r triple, all or none. Cost: as `update`
   * for each, or that of building. Throws as `update`, and "bad-length" unless there is one triple
   * an id.
   */
  updateMany(ids: ArrayLike<number>, lonLatR: ArrayLike<number>): this {
    updateMany(sphericalOf(this, true), ids, lonLatR);
    return this;
  }

  /** Centre and weight of a site, exactly as given. O(1). Throws "unknown-site". */
  site(id: number): SphericalSite {
    return ofOne(sphericalOf(this).native, id, (native) => native.site(id));
  }

  /**
   * All sites, hidden ones too, as typed arrays: `updateMany(ids, lonLatR)` moves them all. O(n).
   */
  sites(): SphericalSites {
    const { ids, xyr, hidden } = sphericalOf(this).native.sites();
    return { ids, lonLatR: xyr, hidden };
  }

  /**
   * All sites, { id, lon, lat, r, hidden }, ascending by id, as they are when the loop begins.
   * O(n).
   */
  *[Symbol.iterator](): Generator<ListedSphericalSite, void> {
    const { ids, lonLatR, hidden } = this.sites();
    for (let k = 0; k < ids.length; ++k) {
      const [lon, lat, r] = [lonLatR[3 * k]!, lonLatR[3 * k + 1]!, lonLatR[3 * k + 2]!];
      yield { id: ids[k]!, lon, lat, r, hidden: hidden[k] === 1 };
    }
  }

  // --- The nearest sites -------------------------------------------------------------------------

  /**
   * The nearest site of a point, -1 if the diagram is empty; with `filter` the nearest that passes,
   * hidden ones too. Cost: one location; with a filter as kNearest. Throws "not-finite",
   * "out-of-range", "bad-option".
   */
  find(lon: number, lat: number, options?: FilterOptions): number {
    return find(sphericalOf(this), lon, lat, options);
  }

  /**
   * `find` with the distance, negative within r of the centre; null if no site is found. Cost,
   * errors: as find.
   */
  nearest(
    lon: number,
    lat: number,
    options?: FilterOptions,
  ): { id: number; distance: number } | null {
    return nearest(sphericalOf(this), lon, lat, options);
  }

  /**
   * The site with the largest distance to its far side, and that distance: the way along a great
   * circle to its centre, plus r. null if the diagram is empty. Of equally far sites, any. Cost:
   * one location. Throws "not-finite", "out-of-range".
   */
  farthest(lon: number, lat: number): { id: number; distance: number } | null {
    return farthest(sphericalOf(this), lon, lat);
  }

  /**
   * `find` for flat longitude, latitude pairs. With `distances` (one element a point) it also fills
   * in the distances, Infinity if no site is found. Cost: m locations for m points; with a filter
   * as Diagram.findMany. Throws as `find`, and "bad-length".
   */
  findMany(lonLat: ArrayLike<number>, ...how: FindManyArguments): Int32Array {
    return findMany(sphericalOf(this), lonLat, how);
  }

  /**
   * The k nearest sites of a point, hidden ones too, nearest first; all sites if there are fewer.
   * `maxDistance` and `filter` leave some out. Cost: one location and O(m log m), m the number of
   * neighbours of the sites looked at. Throws "not-finite", "out-of-range", "bad-option".
   */
  kNearest(lon: number, lat: number, k: number, options?: NearbyOptions): Uint32Array {
    return kNearest(sphericalOf(this), lon, lat, k, options);
  }

  /**
   * All sites whose distance to a point is at most `distance`, hidden ones too, nearest first: with
   * 0 every site whose weight reaches to the point. `filter` leaves some out. Cost, errors: as
   * kNearest.
   */
  within(lon: number, lat: number, distance: number, options?: FilterOptions): Uint32Array {
    return within(sphericalOf(this), lon, lat, distance, options);
  }

  /**
   * The site under a pointer: of those that contain the point, at a distance of at most 0, the one
   * that `top` says; else the nearest, if it is not farther than `maxDistance` (default: Infinity);
   * else -1. `filter` leaves some out. Cost: as kNearest, for the sites that contain the point and
   * one more. Throws as `find`; "out-of-range" also for a negative `maxDistance`.
   */
  pick(lon: number, lat: number, ...how: PickArguments): number {
    return pick(sphericalOf(this), lon, lat, how);
  }

  /** `pick` for flat longitude, latitude pairs. Filter, cost, errors: as findMany, for `pick`. */
  pickMany(lonLat: ArrayLike<number>, ...how: PickArguments): Int32Array {
    return pickMany(sphericalOf(this), lonLat, how);
  }

  // --- The graph ---------------------------------------------------------------------------------

  /**
   * All Voronoi vertices: points that have the same distance to three sites and none less. O(n).
   */
  vertices(): SphericalVertices {
    const { coordinates, clearance, sites } = sphericalOf(this).native.vertices();
    return { lonLat: coordinates, clearance, sites };
  }

  // --- Cells -------------------------------------------------------------------------------------

  /**
   * The cells: a view, always of the diagram as it is now. O(1). Throws "not-finite",
   * "out-of-range", "bad-option".
   */
  voronoi(options?: ViewOptions): SphericalVoronoi {
    return SphericalVoronoi.of(this, options);
  }

  // --- Saving and checking -----------------------------------------------------------------------

  /** "SphericalDiagram". O(1). */
  get [Symbol.toStringTag](): string {
    return "SphericalDiagram";
  }
}
