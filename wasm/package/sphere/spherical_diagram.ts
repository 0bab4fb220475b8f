import { type Accessor, accessorsAndOptions, type Items, readerOf } from "../core/accessors.js";
import {
  checkedBytes,
  checkedChoice,
  checkedCount,
  checkNumber,
  checkOptions,
} from "../core/arguments.js";
import { buildOrDispose } from "../core/building.js";
import { type Inner, innerOf, wrongReceiver } from "../core/inner.js";
import { fillOrDispose } from "../core/native/lifetime.js";
import { type NativeSphericalDiagram, runningModule } from "../core/native/module.js";
import { atPoint, atSite, withSite } from "../core/space.js";
import { SurfaceDiagram } from "../core/surface_diagram.js";
import { trianglesOf } from "../core/triangulation.js";
import type { Edges, Position } from "../core/types.js";
import {
  type CellsCollection,
  checkedProperties,
  checkedWinding,
  featuresOf,
  positionsOf,
} from "../shapes/geojson.js";
import { distanceOf, withDistances } from "../shapes/distances.js";
import { isWithClearance } from "../shapes/edges.js";
import type {
  CellPolygon,
  DistanceOptions,
  EdgeOptions,
  InterpolationOptions,
  NaturalWeights,
  NumbersById,
} from "../shapes/types.js";
import { interpolate } from "./interpolation.js";
import {
  checkedAngularTolerance,
  checkedRadius,
  itemsOf,
  places,
  sphere,
} from "./spherical_arguments.js";
import type {
  ListedSphericalSite,
  Spherical,
  SphericalBuildOptions,
  SphericalCollection,
  SphericalEdgesWithClearance,
  SphericalEmptyCircle,
  SphericalGeoJSONOptions,
  SphericalOptions,
  SphericalPolygonOptions,
  SphericalSite,
  SphericalSites,
  SphericalTriangulation,
  SphericalVertices,
} from "./spherical_types.js";

/** As innerOf; throws "bad-option" also for a diagram of the plane. */
function sphericalOf(diagram: unknown, changes = false): Inner<NativeSphericalDiagram> {
  const inner = innerOf(diagram, changes);
  if (inner.space !== sphere) throw wrongReceiver(diagram);
  return inner as Inner<NativeSphericalDiagram>;
}

function polygonOptions(options: SphericalPolygonOptions | undefined) {
  checkOptions(options, "tolerance", "winding", "distance");
  const winding = checkedWinding(options?.winding);
  return { tolerance: checkedAngularTolerance(options?.tolerance), winding };
}

/**
 * The distances at which all cells end. The module is asked for last, as the caller's options can
 * dispose of the diagram before.
 */
function withReach(diagram: SphericalDiagram, options: DistanceOptions | undefined) {
  const distances = distanceOf(sphericalOf(diagram).native, options);
  return { native: sphericalOf(diagram).native, distances };
}

/** A measure of all cells. */
function measuresOf(
  diagram: SphericalDiagram,
  options: DistanceOptions | undefined,
  measure: (native: NativeSphericalDiagram, distances: ArrayLike<number>) => Float64Array,
): Float64Array {
  sphericalOf(diagram);
  checkOptions(options, "distance");
  const { native, distances } = withReach(diagram, options);
  return withDistances(distances, (list) => measure(native, list));
}

/**
 * The distance at which the cell of a site ends. Throws "unknown-site", and "bad-option" for
 * options that are neither `distance` nor among `others`.
 */
function withCell(
  diagram: SphericalDiagram,
  id: number,
  options: DistanceOptions | undefined,
  ...others: string[]
) {
  withSite(sphericalOf(diagram).native, id);
  checkOptions(options, "distance", ...others);
  const { distances, native } = withReach(diagram, options);
  withSite(native, id);
  if (typeof distances === "number") return { native, distance: distances };
  const distance = distances[id] as number;
  if (distance !== Infinity) checkNumber(`distance[${id}]`, distance);
  return { native, distance };
}

function polygonsOf(
  diagram: SphericalDiagram,
  options: DistanceOptions | undefined,
  tolerance: number,
  isCut: boolean,
) {
  const { native, distances } = withReach(diagram, options);
  return withDistances(distances, (list) => native.cellPolygons(list, tolerance, isCut));
}

/** The names of the sphere. */
interface Sphere {
  place: [lon: number, lat: number];
  places: [lonLat: ArrayLike<number>];
  sites: [lonLatR: ArrayLike<number>];
  site: SphericalSite;
  listed: ListedSphericalSite;
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
export class SphericalDiagram extends SurfaceDiagram<Sphere> {
  /**
   * A diagram of flat longitude, latitude, r triples, or with the option `r` of pairs; their ids
   * are 0, 1, 2, … in input order. Cost: expected O(n log n). Throws "not-finite", "out-of-range"
   * (a latitude, weight or radius), "bad-length" (no multiple of 3, or of 2), "too-large" (more
   * than 2^29 sites), "bad-option".
   */
  constructor(lonLatR?: ArrayLike<number>, options?: SphericalOptions) {
    checkOptions(options, "radius", "r");
    super(runningModule().createSpherical(checkedRadius(options)), sphere);
    const r = options?.r;
    if (lonLatR !== undefined)
      fillOrDispose(this, () => this.insertMany(lonLatR, { r } as { r: number }));
  }

  /**
   * A diagram of any items, read by accessors (item, index, items); with two accessors, items are
   * points. Without accessors an item is an object {lon, lat, r}, an array [lon, lat, r] or a point
   * of GeoJSON, of which a missing r is 0, or `items` are flat numbers as the constructor takes
   * them, or a FeatureCollection. Options come last. Ids are 0, 1, 2, … in input order. Throws as
   * the constructor, naming the item; "bad-option" if an item without r has a `radius`, `size` or
   * `weight`, which nothing would read.
   */
  static from(lonLatR: ArrayLike<number>, options?: SphericalOptions): SphericalDiagram;
  static from<T extends Spherical>(
    items: Items<T> | { readonly type: "FeatureCollection"; readonly features: Items<T> },
    options?: SphericalOptions,
  ): SphericalDiagram;
  static from<T>(
    items: Items<T>,
    lon: Accessor<T>,
    lat: Accessor<T>,
    options?: SphericalOptions,
  ): SphericalDiagram;
  static from<T>(
    items: Items<T>,
    lon: Accessor<T>,
    lat: Accessor<T>,
    r: Accessor<T> | undefined,
    options?: SphericalOptions,
  ): SphericalDiagram;
  static from(items: unknown, ...rest: unknown[]): SphericalDiagram {
    const names = ["radius", "r"];
    const [accessors, options] = accessorsAndOptions<unknown, SphericalOptions>(rest, ...names);
    const radius = checkedRadius(options);
    const reader = readerOf(places(radius), itemsOf(items), accessors, options);
    return new SphericalDiagram(reader.triples(0, reader.count), { radius });
  }

  /**
   * Builds the diagram of `from` in slices of some 8 ms on this thread, between which pages answer
   * and timers run. Not cut are the steps that `Diagram.fromAsync` names. Rejects as `from` throws;
   * with the reason of `options.signal` once that aborts; with what accessors or `onProgress`
   * throw. Then there is no diagram. Cost: about that of `from`.
   */
  static fromAsync(
    lonLatR: ArrayLike<number>,
    options?: SphericalBuildOptions,
  ): Promise<SphericalDiagram>;
  static fromAsync<T extends Spherical>(
    items: Items<T> | { readonly type: "FeatureCollection"; readonly features: Items<T> },
    options?: SphericalBuildOptions,
  ): Promise<SphericalDiagram>;
  static fromAsync<T>(
    items: Items<T>,
    lon: Accessor<T>,
    lat: Accessor<T>,
    options?: SphericalBuildOptions,
  ): Promise<SphericalDiagram>;
  static fromAsync<T>(
    items: Items<T>,
    lon: Accessor<T>,
    lat: Accessor<T>,
    r: Accessor<T> | undefined,
    options?: SphericalBuildOptions,
  ): Promise<SphericalDiagram>;
  static async fromAsync(items: unknown, ...rest: unknown[]): Promise<SphericalDiagram> {
    const names = ["radius", "r", "signal", "onProgress"];
    const [accessors, options] = accessorsAndOptions<unknown, SphericalBuildOptions>(
      rest,
      ...names,
    );
    const radius = checkedRadius(options);
    const reader = readerOf(places(radius), itemsOf(items), accessors, options);
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

  // --- The graph ---------------------------------------------------------------------------------

  /**
   * All Voronoi edges; with `clearance` also the smallest clearance on each, and where that is.
   * O(n). Throws "bad-option".
   */
  override edges(options: EdgeOptions & { clearance: true }): SphericalEdgesWithClearance;
  override edges(options?: EdgeOptions): Edges;
  override edges(options?: EdgeOptions): Edges {
    const isClear = isWithClearance(options);
    const { native } = sphericalOf(this);
    if (!isClear) return native.edges();
    const { xy, clearance } = native.narrowest();
    return Object.assign(native.edges(), { clearance, lonLat: xy });
  }

  /**
   * All Voronoi vertices: points that have the same distance to three sites and none less. O(n).
   */
  vertices(): SphericalVertices {
    const { xy, clearance, sites } = sphericalOf(this).native.vertices();
    return { lonLat: xy, clearance, sites };
  }

  /**
   * The Delaunay graph as it is now, in the arrays of the plane's (d3-delaunay's): a copy, to be
   * asked once. It is closed, a triangulation of the sphere: n >= 3 visible sites have 2 n - 4
   * triangles and 3 n - 6 edges; one or two have no triangle, though two have an edge. O(n).
   */
  triangulation(): SphericalTriangulation {
    return { ...trianglesOf(sphericalOf(this).native), hull: new Uint32Array(0) };
  }

  // --- Empty circles -----------------------------------------------------------------------------

  /**
   * The largest circle that no site reaches into: about the place on the sphere that is farthest
   * from all sites. null without sites. O(n log n).
   */
  largestEmptyCircle(): SphericalEmptyCircle | null {
    return this.emptyCircles(1)[0] ?? null;
  }

  /**
   * The `count` largest of such circles, the largest first, none with its centre in one before it:
   * where to put new sites apart from each other. Fewer if there are no more. Throws "not-finite",
   * "out-of-range" (count). O(n (log n + count)).
   */
  emptyCircles(count: number): SphericalEmptyCircle[] {
    const { native } = sphericalOf(this);
    const { xy, clearance, sites } = native.emptyCircles(checkedCount("count", count));
    return Array.from(clearance, (r, k) => ({
      lon: xy[2 * k]!,
      lat: xy[2 * k + 1]!,
      r,
      site: sites[k]!,
    }));
  }

  // --- Interpolation -----------------------------------------------------------------------------

  /**
   * The natural neighbours of a place, for interpolation (Sibson): the sites from whose cells a new
   * site of weight r there would take a part, and the share of the new cell that comes from each.
   * If a site covers it, that one alone. The diagram stays as it is; null without sites. Cost:
   * location, and the size of what would change. Throws "not-finite", "out-of-range".
   */
  naturalWeights(lon: number, lat: number, r: number = 0): NaturalWeights | null {
    const asked = sphericalOf(this);
    const found = atSite(asked, lon, lat, r, (native) => native.naturalWeights(lon, lat, r));
    if (found.length === 0) return null;
    const ids = Uint32Array.from(found.subarray(0, found.length / 2));
    return { ids, weights: found.slice(ids.length) };
  }

  /**
   * A field at many points: for each of the flat longitude, latitude pairs, what `naturalWeights`
   * says with the sites' `values`, which are given by id; NaN without sites, and next to sites
   * whose value is NaN. Cost: as a loop of `naturalWeights`, without a call for each point. Throws
   * "bad-length" (lonLat; values, one for each id that was ever used, or for each site),
   * "unknown-site", "not-finite", "out-of-range", "bad-option".
   */
  interpolate(
    values: NumbersById,
    lonLat: ArrayLike<number>,
    options?: InterpolationOptions,
  ): Float64Array {
    return interpolate(() => sphericalOf(this), values, lonLat, options);
  }

  // --- Cells -------------------------------------------------------------------------------------

  /**
   * Is this site the nearest one to the point, or one of them? false for a hidden site. Cost: one
   * location. Throws "unknown-site", "not-finite", "out-of-range", "bad-option".
   */
  contains(id: number, lon: number, lat: number, options?: DistanceOptions): boolean {
    const { native, distance } = withCell(this, id, options);
    const asked = { native, space: sphere };
    return atPoint(asked, lon, lat, () => native.contains(id, lon, lat, distance));
  }

  /**
   * The area of a cell, in the square of the radius' unit; null for a hidden site. O(d). Throws
   * "unknown-site", "not-finite", "out-of-range", "bad-option".
   */
  cellArea(id: number, options?: DistanceOptions): number | null {
    const { native, distance } = withCell(this, id, options);
    return native.isHidden(id) ? null : native.cellArea(id, distance);
  }

  /**
   * The areas of all cells by id, 0 for ids without a cell. Without a distance they add up to 4 π
   * radius². Throws "not-finite", "out-of-range", "bad-option"; "broken" if they do not, by a
   * defect of the library. O(n).
   */
  cellAreas(options?: DistanceOptions): Float64Array {
    return measuresOf(this, options, (native, distances) => native.cellAreas(distances));
  }

  /**
   * The length of a cell's boundary, in the radius' unit; null for a hidden site. O(d). Throws as
   * `cellArea`.
   */
  cellPerimeter(id: number, options?: DistanceOptions): number | null {
    const { native, distance } = withCell(this, id, options);
    return native.isHidden(id) ? null : native.cellPerimeter(id, distance);
  }

  /** The perimeters of all cells by id, 0 for ids without a cell. O(n). Throws as `cellAreas`. */
  cellPerimeters(options?: DistanceOptions): Float64Array {
    return measuresOf(this, options, (native, distances) => native.cellPerimeters(distances));
  }

  /**
   * The mean of a cell's points, as a direction: longitude and latitude; null for a hidden site,
   * and for a cell whose distance ends at its centre or before. O(d). Throws as `cellArea`.
   */
  cellCentroid(id: number, options?: DistanceOptions): Position | null {
    const { native, distance } = withCell(this, id, options);
    const { lon, lat } = native.cellCentroid(id, distance);
    return Number.isNaN(lon) ? null : [lon, lat];
  }

  /**
   * A cell as one closed ring of longitudes and latitudes, to be joined by arcs of great circles;
   * null for a hidden site, and for a cell whose distance ends at its centre or before; [] where
   * the cell is the whole sphere. O(d + points). Throws "unknown-site", "not-finite",
   * "out-of-range", "bad-option".
   */
  cellPolygon(id: number, options?: SphericalPolygonOptions): Position[] | null {
    const { native, distance } = withCell(this, id, options, "tolerance", "winding");
    const { tolerance, winding } = polygonOptions(options);
    if (native.isHidden(id)) return null;
    const { coordinates } = native.cellPolygon(id, tolerance, false, distance);
    if (coordinates.length === 0 && native.cellArea(id, distance) === 0) return null;
    const ring = positionsOf(coordinates);
    return winding === "clockwise" ? ring.reverse() : ring;
  }

  /**
   * The polygons of all cells that are not empty, as they are when the loop begins, ascending by
   * id, which is their `index`. Cost: O(n + points), a third of `cellPolygon` in a loop.
   */
  *cellPolygons(options?: SphericalPolygonOptions): Generator<CellPolygon, void> {
    const { tolerance, winding } = polygonOptions(options);
    const polygons = polygonsOf(this, options, tolerance, false);
    const { coordinates, starts, parts, sites, cells } = polygons;
    for (const [k, index] of sites.entries()) {
      const [first, end] = [starts[parts[cells[k]!]!]!, starts[parts[cells[k + 1]!]!]!];
      const ring = positionsOf(coordinates, first, end);
      yield Object.assign(winding === "clockwise" ? ring.reverse() : ring, { index });
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
    checkOptions(options, "tolerance", "properties", "winding", "antimeridian", "distance");
    const properties = checkedProperties<Properties>(options?.properties);
    const winding = checkedWinding(options?.winding);
    const antimeridian = checkedChoice<"cut" | "keep">(
      "options.antimeridian",
      options?.antimeridian,
      winding === "clockwise" ? ["keep", "cut"] : ["cut", "keep"],
    );
    const tolerance = checkedAngularTolerance(options?.tolerance);
    const polygons = polygonsOf(this, options, tolerance, antimeridian === "cut");
    const collection = featuresOf(polygons, properties, winding);
    if (polygons.parts.length > 1 || polygons.sites.length === 0) return collection;
    // The only visible site's, which is the whole sphere.
    const features = collection.features.map((feature) => ({
      ...feature,
      geometry: { type: "Sphere" as const },
    }));
    return { type: collection.type, features };
  }

  // --- Saving and checking -----------------------------------------------------------------------

  /** "SphericalDiagram". O(1). */
  get [Symbol.toStringTag](): string {
    return "SphericalDiagram";
  }
}
