/// <reference lib="esnext.disposable" preserve="true" />
import type { Accessor, Items } from "../core/accessors.js";
import {
  allocated,
  checkedBytes,
  checkedChoice,
  checkedCount,
  checkedIds,
  checkOptions,
  checkSiteId,
  checkWholeNumber,
  isSiteId,
  unknownSite,
} from "../core/arguments.js";
import {
  checkedFilter,
  filterOf,
  type Filters,
  findMany,
  firstOf,
  passing,
} from "../core/filters.js";
import { kInspect, showContent, summary } from "../core/inspection.js";
import {
  Ballast,
  createSpherical,
  destroy,
  fillOrDispose,
  wrongReceiver,
} from "../core/native/lifetime.js";
import {
  type NativeSphericalDiagram,
  runningModule,
  type SphericalNearestFirst,
} from "../core/native/module.js";
import { checkedMaxDistance, orInfinity, validate } from "../core/queries.js";
import type {
  Edges,
  FilterOptions,
  FindManyArguments,
  NearbyOptions,
  Position,
} from "../core/types.js";
import { ApolloniusError } from "../errors.js";
import {
  type CellsCollection,
  checkedProperties,
  checkedWinding,
  featuresOf,
  positionsOf,
} from "../shapes/geojson.js";
import type { CellPolygon } from "../shapes/types.js";
import {
  accessorsAndOptions,
  checkedAngularTolerance,
  checkedPoints,
  checkedRadius,
  checkedSites,
  checkPoint,
  checkSite,
  sphericalTriples,
} from "./spherical_arguments.js";
import type {
  ListedSphericalSite,
  Spherical,
  SphericalCollection,
  SphericalGeoJSONOptions,
  SphericalOptions,
  SphericalPolygonOptions,
  SphericalSite,
  SphericalSites,
  SphericalVertices,
} from "./spherical_types.js";

/** The native diagram; "busy" for a call that `changes` it while a filter runs. */
let living: (diagram: unknown, changes?: boolean) => NativeSphericalDiagram;

/** The same diagram, of which this is a site. */
function withSite(native: NativeSphericalDiagram, id: number): NativeSphericalDiagram {
  checkSiteId(id);
  if (!native.has(id)) throw unknownSite(id);
  return native;
}

function walkFrom(
  native: NativeSphericalDiagram,
  lon: number,
  lat: number,
  farthest: number,
): SphericalNearestFirst {
  return native.nearestFirst(lon, lat, farthest) as SphericalNearestFirst;
}

function findAll(
  native: NativeSphericalDiagram,
  numbers: ArrayLike<number>,
  distances?: Float64Array,
): Int32Array {
  const ids = allocated(() => new Int32Array(numbers.length / 2));
  native.findMany(numbers, ids, distances ?? null);
  return ids;
}

function nearby(
  native: NativeSphericalDiagram,
  filters: Filters,
  [lon, lat]: Position,
  most: number,
  farthest: number,
  filter: unknown,
): Uint32Array {
  const checked = checkedFilter(filter);
  if (checked === undefined) return native.kNearest(lon, lat, most, farthest);
  return firstOf(walkFrom(native, lon, lat, farthest), most, checked, filters);
}

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
export class SphericalDiagram implements Disposable {
  #native: NativeSphericalDiagram | null;
  readonly #ballast = new Ballast();
  readonly #filters: Filters = { running: 0 };

  static {
    living = (diagram, changes = false) => {
      if (typeof diagram !== "object" || diagram === null || !(#native in diagram))
        throw wrongReceiver(diagram);
      if (changes && diagram.#filters.running > 0)
        throw new ApolloniusError("busy", "a filter may not change the diagram that asks it");
      if (diagram.#native === null)
        throw new ApolloniusError("disposed", "the diagram has been disposed of");
      return diagram.#native;
    };
  }

  /**
   * A diagram of flat longitude, latitude, r triples; their ids are 0, 1, 2, … in input order.
   * Cost: expected O(n log n). Throws "not-finite", "out-of-range" (a latitude, weight or radius),
   * "bad-length" (no multiple of 3), "too-large" (more than 2^29 triples), "bad-option".
   */
  constructor(lonLatR?: ArrayLike<number>, options?: SphericalOptions) {
    checkOptions(options, "radius");
    this.#native = createSpherical(this, checkedRadius(options));
    showContent(this);
    if (lonLatR !== undefined) fillOrDispose(this, () => this.insertMany(lonLatR));
  }

  /**
   * A diagram of any items, read by accessors (item, index, items); with two of them of points.
   * Without accessors an item is an object {lon, lat, r}, an array [lon, lat, r] or a point of
   * GeoJSON, and `items` may be a FeatureCollection; a missing r is 0. Options may come at any
   * place. Ids are 0, 1, 2, … in input order. Throws as the constructor, naming the item.
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
    const { accessors, options } = accessorsAndOptions<unknown>(rest);
    const radius = checkedRadius(options);
    const triples = sphericalTriples(items as Items<unknown>, accessors, radius);
    return new SphericalDiagram(triples, { radius });
  }

  /**
   * The diagram that `toBytes` saved, with its radius and ids. Throws "corrupt-snapshot",
   * "bad-length" (no Uint8Array). Cost: that of building.
   */
  static fromBytes(bytes: Uint8Array): SphericalDiagram {
    const diagram = new SphericalDiagram();
    fillOrDispose(diagram, () => {
      living(diagram).fromBytes(checkedBytes("bytes", bytes));
      diagram.#ballast.carry(diagram.size);
    });
    return diagram;
  }

  // --- Sites -------------------------------------------------------------------------------------

  /** The sphere's radius. O(1). */
  get radius(): number {
    return living(this).radius();
  }

  /**
   * Adds a site and returns its id. Cost: one location and O(size of the change); that of building
   * when the number of sites has doubled, and for one site in n. Throws "not-finite",
   * "out-of-range".
   */
  insert(lon: number, lat: number, r: number = 0): number {
    const native = living(this, true);
    checkSite(lon, lat, r, native.radius());
    const id = native.insert(lon, lat, r);
    this.#ballast.carry(id + 1);
    return id;
  }

  /**
   * Adds flat longitude, latitude, r triples, all or none; returns their ids in input order. Cost:
   * expected O(m log n) for m triples, and that of building as for `insert`. Throws as `insert`,
   * and "bad-length", "too-large".
   */
  insertMany(lonLatR: ArrayLike<number>): Uint32Array {
    const native = living(this, true);
    const numbers = checkedSites("lonLatR", lonLatR, native.radius());
    const ids = allocated(() => new Uint32Array(numbers.length / 3));
    native.insertMany(numbers, ids);
    this.#ballast.carry(native.size());
    return ids;
  }

  /**
   * Removes a site; false if there is no such site. Sites that only it covered become visible.
   * Cost: as in the plane, and for one site in n that of building. Throws "unknown-site" for what
   * is no whole number.
   */
  remove(id: number): boolean {
    const native = living(this, true);
    checkWholeNumber(id);
    return isSiteId(id) && native.remove(id);
  }

  /** Removes several sites; returns how many there were. Throws as `remove`, and "bad-length". */
  removeMany(ids: ArrayLike<number>): number {
    return living(this, true).removeMany(checkedIds("ids", ids));
  }

  /**
   * Moves and/or reweights a site, which keeps its id; without r it keeps its weight. Cost: as
   * remove and insert. Throws "unknown-site", "not-finite", "out-of-range".
   */
  update(id: number, lon: number, lat: number, r?: number): this {
    const native = living(this, true);
    const weight = r === undefined ? withSite(native, id).site(id).r : r;
    checkSite(lon, lat, weight, native.radius());
    withSite(native, id).update(id, lon, lat, weight);
    return this;
  }

  /**
   * Updates site ids[k] to the k-th longitude, latitude, r triple, all or none. Cost: as `update`
   * for each, or that of building. Throws as `update`, and "bad-length" unless there is one triple
   * an id.
   */
  updateMany(ids: ArrayLike<number>, lonLatR: ArrayLike<number>): this {
    const native = living(this, true);
    const sites = checkedIds("ids", ids);
    const numbers = checkedSites("lonLatR", lonLatR, native.radius());
    if (numbers.length !== 3 * sites.length)
      throw new ApolloniusError(
        "bad-length",
        `expected ${3 * sites.length} values in lonLatR for ${sites.length} ids, got ` +
          numbers.length,
      );
    const unknown = sites.findIndex((id) => !native.has(id));
    if (unknown !== -1)
      throw new ApolloniusError(
        "unknown-site",
        `ids[${unknown}]: ${unknownSite(ids[unknown]).message}`,
      );
    native.updateMany(sites, numbers);
    return this;
  }

  /** Removes all sites; ids start from 0 again. Cost: O(n). */
  clear(): this {
    living(this, true).clear();
    return this;
  }

  /** Number of sites, hidden ones too. O(1). */
  get size(): number {
    return living(this).size();
  }

  /** Number of sites that have a cell. O(1). */
  get visibleSize(): number {
    return living(this).visibleSize();
  }

  /** Number of sites that have none: another covers them. O(1). */
  get hiddenSize(): number {
    return this.size - this.visibleSize;
  }

  /** Whether a site has this id. O(1). Throws "unknown-site" for what is no whole number. */
  has(id: number): boolean {
    const native = living(this);
    checkWholeNumber(id);
    return isSiteId(id) && native.has(id);
  }

  /** Centre and weight of a site, exactly as given. O(1). Throws "unknown-site". */
  site(id: number): SphericalSite {
    return withSite(living(this), id).site(id);
  }

  /** All ids, ascending. O(n). */
  ids(): Uint32Array {
    return living(this).ids();
  }

  /**
   * All sites, hidden ones too, as typed arrays: `updateMany(ids, lonLatR)` moves them all. O(n).
   */
  sites(): SphericalSites {
    const { ids, xyr, hidden } = living(this).sites();
    return { ids, lonLatR: xyr, hidden };
  }

  /** All sites, { id, lon, lat, r, hidden }, ascending by id, as the loop finds them. O(n). */
  *[Symbol.iterator](): Generator<ListedSphericalSite, void> {
    const { ids, lonLatR, hidden } = this.sites();
    for (let k = 0; k < ids.length; ++k) {
      const [lon, lat, r] = [lonLatR[3 * k]!, lonLatR[3 * k + 1]!, lonLatR[3 * k + 2]!];
      yield { id: ids[k]!, lon, lat, r, hidden: hidden[k] === 1 };
    }
  }

  /** Whether the site's cell is empty, because some site covers it. O(1). Throws "unknown-site". */
  isHidden(id: number): boolean {
    return withSite(living(this), id).isHidden(id);
  }

  /**
   * A visible site that covers this one; -1 for a visible site. Cost: one location. Throws
   * "unknown-site".
   */
  coverOf(id: number): number {
    return withSite(living(this), id).coverOf(id);
  }

  // --- Queries -----------------------------------------------------------------------------------

  /**
   * The nearest site of a point, -1 if the diagram is empty; with `filter` the nearest that passes,
   * hidden ones too. Cost: one location; with a filter as kNearest. Throws "not-finite",
   * "out-of-range", "bad-option".
   */
  find(lon: number, lat: number, options?: FilterOptions): number {
    const native = living(this);
    checkPoint(lon, lat);
    const filter = filterOf(options);
    if (filter !== undefined)
      return passing(walkFrom(native, lon, lat, Infinity), filter, this.#filters)?.id ?? -1;
    return native.find(lon, lat); // without the distance, which costs as much as the search
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
    const native = living(this);
    checkPoint(lon, lat);
    const filter = filterOf(options);
    if (filter !== undefined)
      return passing(walkFrom(native, lon, lat, Infinity), filter, this.#filters);
    const found = native.nearest(lon, lat);
    return found.id === -1 ? null : found;
  }

  /**
   * `find` for flat longitude, latitude pairs. With `distances` (one element a point) it also fills
   * in the distances, Infinity if no site is found. Cost: m locations for m points; with a filter
   * as Diagram.findMany. Throws as `find`, and "bad-length".
   */
  findMany(lonLat: ArrayLike<number>, ...how: FindManyArguments): Int32Array {
    const native = living(this);
    return findMany(native, this.#filters, checkedPoints("lonLat", lonLat), how, {
      all: findAll,
      one: (lon, lat, filter) =>
        passing(walkFrom(native, lon, lat, Infinity), filter, this.#filters),
      empty: () => runningModule().createSpherical(native.radius()),
    });
  }

  /**
   * The k nearest sites of a point, hidden ones too, nearest first; all sites if there are fewer.
   * `maxDistance` and `filter` leave some out. Cost: one location and O(m log m), m the number of
   * neighbours of the sites looked at. Throws "not-finite", "out-of-range", "bad-option".
   */
  kNearest(lon: number, lat: number, k: number, options?: NearbyOptions): Uint32Array {
    const native = living(this);
    checkPoint(lon, lat);
    const most = checkedCount("k", k);
    checkOptions(options, "maxDistance", "filter");
    const farthest = checkedMaxDistance("options.maxDistance", orInfinity(options?.maxDistance));
    return nearby(native, this.#filters, [lon, lat], most, farthest, options?.filter);
  }

  /**
   * All sites whose distance to a point is at most `distance`, hidden ones too, nearest first: with
   * 0 every site whose weight reaches to the point. `filter` leaves some out. Cost, errors: as
   * kNearest.
   */
  within(lon: number, lat: number, distance: number, options?: FilterOptions): Uint32Array {
    const native = living(this);
    checkPoint(lon, lat);
    const farthest = checkedMaxDistance("distance", distance);
    checkOptions(options, "filter");
    const most = checkedCount("k", Infinity);
    return nearby(native, this.#filters, [lon, lat], most, farthest, options?.filter);
  }

  /**
   * The distinct sites whose cells share an edge with this site's, counter-clockwise as seen from
   * outside; empty for a hidden site. Edges of length zero count, in so far as rounding makes some.
   * O(d). Throws "unknown-site".
   */
  neighbors(id: number): Uint32Array {
    return withSite(living(this), id).neighbors(id);
  }

  /** All Voronoi edges; the closed edge of two sites has the vertices -1, -1. O(n). */
  edges(): Edges {
    return living(this).edges();
  }

  /**
   * All Voronoi vertices: points that have the same distance to three sites and none less. O(n).
   */
  vertices(): SphericalVertices {
    const { coordinates, clearance, sites } = living(this).vertices();
    return { lonLat: coordinates, clearance, sites };
  }

  // --- Cells -------------------------------------------------------------------------------------

  /**
   * Is this site the nearest one to the point, or one of them? false for a hidden site. Cost: one
   * location. Throws "unknown-site", "not-finite", "out-of-range".
   */
  contains(id: number, lon: number, lat: number): boolean {
    const native = withSite(living(this), id);
    checkPoint(lon, lat);
    return native.contains(id, lon, lat);
  }

  /**
   * The area of a cell, in the square of the radius' unit; 0 for a hidden site. O(d). Throws
   * "unknown-site".
   */
  cellArea(id: number): number {
    return withSite(living(this), id).cellArea(id);
  }

  /**
   * The areas of all cells by id, 0 for ids without a cell; they add up to 4 π radius². Throws
   * "broken" if they do not, by a defect of the library. O(n).
   */
  cellAreas(): Float64Array {
    return living(this).cellAreas();
  }

  /**
   * The mean of a cell's points, as a direction: longitude and latitude; null for a hidden site.
   * O(d). Throws "unknown-site".
   */
  cellCentroid(id: number): Position | null {
    const native = withSite(living(this), id);
    if (native.isHidden(id)) return null;
    const { lon, lat } = native.cellCentroid(id);
    return [lon, lat];
  }

  /**
   * A cell as one closed ring of longitudes and latitudes, to be joined by arcs of great circles;
   * null for a hidden site, [] where the cell is the whole sphere. O(d + points). Throws
   * "unknown-site", "not-finite", "out-of-range", "bad-option".
   */
  cellPolygon(id: number, options?: SphericalPolygonOptions): Position[] | null {
    const native = withSite(living(this), id);
    checkOptions(options, "tolerance", "winding");
    const winding = checkedWinding(options?.winding);
    const tolerance = checkedAngularTolerance(options?.tolerance);
    if (native.isHidden(id)) return null;
    const ring = positionsOf(native.cellPolygon(id, tolerance, false).coordinates);
    return winding === "clockwise" ? ring.reverse() : ring;
  }

  /** The polygons of all cells, ascending by id, which is their `index`. Cost: as cellPolygon. */
  *cellPolygons(options?: SphericalPolygonOptions): Generator<CellPolygon, void> {
    for (const id of this.ids()) {
      const ring = this.cellPolygon(id, options);
      if (ring !== null) yield Object.assign(ring, { index: id });
    }
  }

  /**
   * All cells as GeoJSON, ascending by id. Neighbours have the points of their common boundary in
   * common, whatever the tolerance. For maps by default (RFC 7946: cut at the antimeridian); for
   * d3-geo `{ winding: "clockwise" }`. O(n). Throws "not-finite", "out-of-range", "bad-option", and
   * what `properties` throws; "broken" if cut cells are not the whole map, a defect of the library.
   */
  toGeoJSON<Properties = { site: number }>(
    options?: SphericalGeoJSONOptions<Properties> & {
      winding?: "counter-clockwise" | undefined;
      antimeridian?: "cut" | undefined;
    },
  ): CellsCollection<Properties>;
  toGeoJSON<Properties = { site: number }>(
    options?: SphericalGeoJSONOptions<Properties>,
  ): SphericalCollection<Properties>;
  toGeoJSON<Properties = { site: number }>(
    options?: SphericalGeoJSONOptions<Properties>,
  ): SphericalCollection<Properties> {
    checkOptions(options, "tolerance", "properties", "winding", "antimeridian");
    const properties = checkedProperties<Properties>(options?.properties);
    const winding = checkedWinding(options?.winding);
    const antimeridian = checkedChoice<"cut" | "keep">(
      "options.antimeridian",
      options?.antimeridian,
      winding === "clockwise" ? ["keep", "cut"] : ["cut", "keep"],
    );
    const tolerance = checkedAngularTolerance(options?.tolerance);
    // asked last, as the caller's options can dispose of the diagram before
    const polygons = living(this).cellPolygons(tolerance, antimeridian === "cut");
    const collection = featuresOf(polygons, properties, winding);
    if (polygons.parts.length > 1) return collection;
    // The only visible site's, which is the whole sphere.
    const features = collection.features.map((feature) => ({
      ...feature,
      geometry: { type: "Sphere" as const },
    }));
    return { type: collection.type, features };
  }

  // --- Snapshots and life time -------------------------------------------------------------------

  /**
   * The diagram as bytes, 28 a site and 8 more a hidden one: the restored diagram gives the same
   * answers, of identical sites the same one is visible, and new sites get the same ids. O(n).
   */
  toBytes(): ReturnType<Uint8Array["slice"]> {
    return living(this).toBytes();
  }

  /** The sites, for JSON; `SphericalDiagram.from` reads them, with new ids. O(n). */
  toJSON(): ListedSphericalSite[] {
    return [...this];
  }

  /** "SphericalDiagram { size: 3, hidden: 1 }". O(1). */
  toString(): string {
    return summary(this, "SphericalDiagram");
  }

  /** @internal */
  [kInspect](): string {
    return this.toString();
  }

  /** "SphericalDiagram". O(1). */
  get [Symbol.toStringTag](): string {
    return "SphericalDiagram";
  }

  /** null, or the first broken invariant in words. Slow, O(n) with large constants: for tests. */
  validate(): string | null {
    return validate(living(this));
  }

  /** Frees the diagram's memory now; later calls throw "disposed". Cost: O(1). */
  dispose(): void {
    if (this.#native === null) return;
    destroy(living(this, true));
    this.#native = null;
    this.#ballast.drop();
  }

  /** `dispose`, for `using diagram = new SphericalDiagram()`. Cost: O(1). */
  [Symbol.dispose](): void {
    this.dispose();
  }
}
