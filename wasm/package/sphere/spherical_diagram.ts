import { type Accessor, accessorsAndOptions, type Items, readerOf } from "../core/accessors.js";
import { checkOptions } from "../core/arguments.js";
import { buildOrDispose, restore, restoreOrDispose } from "../core/building.js";
import { fillOrDispose } from "../core/native/lifetime.js";
import { runningModule } from "../core/native/module.js";
import { SurfaceDiagram } from "../core/surface_diagram.js";
import { trianglesOf } from "../core/triangulation.js";
import type { AsyncOptions, Edges } from "../core/types.js";
import { isWithClearance } from "../shapes/edges.js";
import type { EdgeOptions, ViewOptions } from "../shapes/types.js";
import { checkedRadius, itemsOf, places, sphere, sphericalOf } from "./spherical_arguments.js";
import type {
  ListedSphericalSite,
  Spherical,
  SphericalBuildOptions,
  SphericalEdgesWithClearance,
  SphericalOptions,
  SphericalSite,
  SphericalSites,
  SphericalTriangulation,
  SphericalVertices,
} from "./spherical_types.js";
import { SphericalVoronoi } from "./spherical_voronoi.js";

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
 * differences matter to the diagram. Magnitudes below 1e-100 are taken as 0, and 0 comes back. n is
 * the number of sites, d the number of a site's neighbours.
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
  // The overload for items comes first: after one for numbers, TypeScript takes the "Point" of a
  // GeoJSON object that a function returns for any string.
  static from<T extends Spherical>(
    items: Items<T> | { readonly type: "FeatureCollection"; readonly features: Items<T> },
    options?: SphericalOptions,
  ): SphericalDiagram;
  static from(lonLatR: ArrayLike<number>, options?: SphericalOptions): SphericalDiagram;
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
  static fromAsync<T extends Spherical>(
    items: Items<T> | { readonly type: "FeatureCollection"; readonly features: Items<T> },
    options?: SphericalBuildOptions,
  ): Promise<SphericalDiagram>;
  static fromAsync(
    lonLatR: ArrayLike<number>,
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
   * "bad-length" (no bytes). Cost: that of building.
   */
  static fromBytes(bytes: Uint8Array | ArrayBuffer): SphericalDiagram {
    const diagram = new SphericalDiagram();
    fillOrDispose(diagram, () => restore(diagram, bytes, false));
    return diagram;
  }

  /**
   * `fromBytes` in slices of some 8 ms on this thread, between which pages answer and timers run.
   * Not cut are the copy of the bytes and the steps that `fromAsync` does not cut. Rejects as
   * `fromBytes` throws; with the reason of `options.signal` once that aborts; with what
   * `onProgress` throws. Cost: that of `fromBytes`.
   */
  static async fromBytesAsync(
    bytes: Uint8Array | ArrayBuffer,
    options?: AsyncOptions,
  ): Promise<SphericalDiagram> {
    checkOptions(options, "signal", "onProgress");
    const diagram = new SphericalDiagram();
    await restoreOrDispose(diagram, bytes, false, options ?? {});
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

  // --- Cells -------------------------------------------------------------------------------------

  /**
   * The cells: a view, always of the diagram as it is now. O(1). Throws "not-finite",
   * "out-of-range", "bad-option".
   */
  voronoi(options?: ViewOptions): SphericalVoronoi {
    return SphericalVoronoi.of(this, options);
  }

  // --- Saving ------------------------------------------------------------------------------------

  /** "SphericalDiagram". O(1). */
  get [Symbol.toStringTag](): string {
    return "SphericalDiagram";
  }
}
