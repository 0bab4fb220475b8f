// The cells of a diagram of the sphere.
import type { CoverageArrays } from "../../../build/wasm/apollonius.mjs";
import { checkedChoice, checkedCount, checkOptions } from "../core/arguments.js";
import { type Inner, wrongReceiver } from "../core/inner.js";
import { showInWords } from "../core/inspection.js";
import type { NativeSphericalDiagram } from "../core/native/module.js";
import { withSite } from "../core/space.js";
import type { AsyncOptions, Edges, Position } from "../core/types.js";
import { ApolloniusError } from "../errors.js";
import { circleOrNull, circlesInSlices } from "../shapes/circles.js";
import {
  type CellMesh,
  type CellGeometry,
  type CellsCollection,
  checkedProperties,
  checkedWinding,
  featuresOf,
  geometryOf,
  meshOf,
} from "../shapes/geojson.js";
import {
  type Asked,
  interpolate,
  interpolateAsync,
  naturalWeights,
} from "../shapes/interpolation.js";
import { checkedLimit, contains, limitOf, limitsOf } from "../shapes/limits.js";
import type {
  EdgeOptions,
  AsyncInterpolationOptions,
  CellPolygon,
  InterpolationOptions,
  MaxDistance,
  NaturalWeights,
  NumbersById,
  ViewOptions,
} from "../shapes/types.js";
import { checkedTolerance, sphericalOf } from "./spherical_arguments.js";
import type {
  CutAtAntimeridian,
  SphericalCellCircle,
  SphericalCollection,
  SphericalEdgesWithClearance,
  SphericalEmptyCircle,
  SphericalGeoJSONOptions,
  SphericalGeometry,
  SphericalGeometryOptions,
  SphericalMeasures,
  SphericalPolygonOptions,
  SphericalVertices,
} from "./spherical_types.js";

type Native = NativeSphericalDiagram;
/** The type alone, of the file that imports this one. */
type SphericalDiagram = import("./spherical_diagram.js").SphericalDiagram;

/**
 * The cells of a diagram of the sphere, as measures and polygons: `diagram.voronoi()`. A view
 * always shows the diagram as it is now. Its calls are those of the plane's `Voronoi`. There is no
 * window, so cells have one part, without holes, and none is outside; there are no drawings, as
 * maps are drawn from GeoJSON, and no curves, as no file format has bisectors of the sphere.
 *
 * Everywhere: an id without a site throws "unknown-site"; a hidden site, which has no cell, and a
 * cell that ends at its site's centre or before give nothing: null for places and shapes, 0 for
 * areas and lengths, NaN for coordinates in lists. Options throw "not-finite" or "out-of-range",
 * unknown ones "bad-option". n is the number of sites, d the number of a site's neighbours.
 */
export class SphericalVoronoi {
  /** The diagram that is looked at. */
  readonly diagram: SphericalDiagram;
  readonly #limit: MaxDistance;

  /** `diagram.voronoi()` makes it. */
  private constructor(diagram: SphericalDiagram, options: ViewOptions | undefined) {
    sphericalOf(diagram);
    checkOptions(options, "maxDistance");
    this.#limit = checkedLimit(options);
    this.diagram = diagram;
    showInWords(this);
    Object.freeze(this);
  }

  /** @internal For `diagram.voronoi()`. */
  static of(diagram: SphericalDiagram, options: ViewOptions | undefined): SphericalVoronoi {
    return new SphericalVoronoi(diagram, options);
  }

  /** "SphericalVoronoi". */
  get [Symbol.toStringTag](): string {
    return "SphericalVoronoi";
  }

  // --- Shapes ------------------------------------------------------------------------------------

  /**
   * A cell as one closed ring of longitudes and latitudes, to be joined by arcs of great circles.
   * O(d + points). Throws "out-of-range" also where the cell is the whole sphere, which has no
   * ring: `cellGeometry` says what it is.
   */
  cellPolygon(id: number, options?: SphericalPolygonOptions): Position[] | null {
    const inner = SphericalVoronoi.#innerFor(this, id);
    checkOptions(options, "tolerance", "winding");
    const winding = checkedWinding(options?.winding);
    const tolerance = checkedTolerance(options, inner.native.radius());
    const geometry = SphericalVoronoi.#geometryOf(this, id, tolerance, false, winding);
    if (geometry?.type === "Sphere") throw noRing(id);
    return geometry && (geometry.coordinates[0] as Position[]);
  }

  /**
   * The polygons of all cells that are not empty, as they are when the loop begins, ascending by
   * id, which is their `index`. O(n + points), a third of `cellPolygon` in a loop. Throws as that.
   */
  *cellPolygons(options?: SphericalPolygonOptions): Generator<CellPolygon, void> {
    const { native } = SphericalVoronoi.#inner(this);
    checkOptions(options, "tolerance", "winding");
    const winding = checkedWinding(options?.winding);
    const tolerance = checkedTolerance(options, native.radius());
    const polygons = SphericalVoronoi.#polygons(this, tolerance, false);
    if (isSphere(polygons)) throw noRing(polygons.sites[0]!);
    for (const [k, index] of polygons.sites.entries()) {
      const { coordinates } = geometryOf(polygons, k, winding);
      yield Object.assign(coordinates[0] as Position[], { index });
    }
  }

  /**
   * A cell as a geometry of GeoJSON, as `toGeoJSON` has those of all, which also have a point where
   * a neighbour ends sooner; null for a hidden site. O(d + points).
   */
  cellGeometry(
    id: number,
    options?: SphericalGeometryOptions & CutAtAntimeridian,
  ): CellGeometry | null;
  cellGeometry(id: number, options?: SphericalGeometryOptions): SphericalGeometry | null;
  cellGeometry(id: number, options?: SphericalGeometryOptions): SphericalGeometry | null {
    const inner = SphericalVoronoi.#innerFor(this, id);
    checkOptions(options, "tolerance", "winding", "antimeridian");
    const { winding, isCut, tolerance } = geometryOptions(inner, options);
    return SphericalVoronoi.#geometryOf(this, id, tolerance, isCut, winding);
  }

  /**
   * The edges between cells as lines of GeoJSON, each once, through the points of `cellPolygons`,
   * which arcs of great circles join. Boundaries at a maxDistance, which no neighbour shares, are
   * left out. O(n + points).
   */
  cellMesh(options?: Pick<SphericalPolygonOptions, "tolerance">): CellMesh {
    const { native } = SphericalVoronoi.#inner(this);
    checkOptions(options, "tolerance");
    return meshOf(
      SphericalVoronoi.#polygons(this, checkedTolerance(options, native.radius()), false),
    );
  }

  /**
   * All cells as GeoJSON, ascending by id. Neighbours have the points of their common boundary in
   * common, whatever the tolerance. For maps by default (RFC 7946: cut at the antimeridian); for
   * d3-geo `{ winding: "clockwise" }`. O(n + points). Throws what `properties` throws; "broken" if
   * cut cells are not the whole map, a defect of the library.
   */
  toGeoJSON<Properties = { site: number }>(
    options?: SphericalGeoJSONOptions<Properties> & CutAtAntimeridian,
  ): CellsCollection<Properties>;
  toGeoJSON<Properties = { site: number }>(
    options?: SphericalGeoJSONOptions<Properties>,
  ): SphericalCollection<Properties>;
  toGeoJSON<Properties = { site: number }>(
    options?: SphericalGeoJSONOptions<Properties>,
  ): SphericalCollection<Properties> {
    const inner = SphericalVoronoi.#inner(this);
    checkOptions(options, "tolerance", "winding", "antimeridian", "properties");
    const properties = checkedProperties<Properties>(options?.properties);
    const { winding, isCut, tolerance } = geometryOptions(inner, options);
    const polygons = SphericalVoronoi.#polygons(this, tolerance, isCut);
    const collection: SphericalCollection<Properties> = featuresOf(polygons, properties, winding);
    if (isSphere(polygons)) collection.features[0]!.geometry = { type: "Sphere" };
    return collection;
  }

  // --- Points, neighbours, the graph -------------------------------------------------------------

  /**
   * Is this site the nearest one to the point, and within the view's maxDistance? That is
   * `diagram.find(lon, lat, { maxDistance }) === id`, ties as there. false for a hidden site. Cost:
   * one location.
   */
  contains(id: number, lon: number, lat: number): boolean {
    return contains(SphericalVoronoi.#innerFor(this, id), this.#limit, id, lon, lat);
  }

  /**
   * The sites whose cells have an edge in common with this one's within the maxDistance of both,
   * counter-clockwise, each once. Of two neighbours each has the other. Where cells meet in a point
   * only, rounding decides, as in `diagram.neighbors`. O(d).
   */
  neighbors(id: number): Uint32Array {
    const inner = SphericalVoronoi.#innerFor(this, id);
    if (this.#limit === Infinity) return inner.native.neighbors(id);
    const own = limitOf(inner, this.#limit, id);
    // The ids, one an edge, and how near each edge comes.
    const edges = SphericalVoronoi.#innerFor(this, id).native.cellNeighbors(id);
    const count = edges.length / 2;
    const limits = new Map<number, number>(); // of both, by neighbour
    const found = new Set<number>();
    for (let k = 0; k < count; ++k) {
      const other = edges[k]!;
      if (!limits.has(other)) limits.set(other, Math.min(own, limitOf(inner, this.#limit, other)));
      if (edges[count + k]! < limits.get(other)!) found.add(other);
    }
    return Uint32Array.from(found);
  }

  /** The Voronoi vertices, `diagram.vertices()`, whatever the maxDistance. O(n). */
  vertices(): SphericalVertices {
    SphericalVoronoi.#inner(this);
    return this.diagram.vertices();
  }

  /** The Voronoi edges, `diagram.edges()`, whatever the maxDistance. O(n). */
  edges(options: EdgeOptions & { clearance: true }): SphericalEdgesWithClearance;
  edges(options?: EdgeOptions): Edges;
  edges(options?: EdgeOptions): Edges {
    SphericalVoronoi.#inner(this);
    return this.diagram.edges(options);
  }

  // --- Empty circles, and room for labels --------------------------------------------------------

  /**
   * The largest circle that no site reaches into: about the place on the sphere that is farthest
   * from all sites. null without sites. A maxDistance does not matter. O(n log n).
   */
  largestEmptyCircle(): SphericalEmptyCircle | null {
    SphericalVoronoi.#inner(this);
    return this.emptyCircles(1)[0] ?? null;
  }

  /**
   * The `count` largest of such circles, the largest first, none with its centre in one before it:
   * where to put new sites apart from each other. Fewer if there are no more. A maxDistance does
   * not matter. Throws "not-finite", "out-of-range" (count). O(n (log n + count)).
   */
  emptyCircles(count: number): SphericalEmptyCircle[] {
    const { native } = SphericalVoronoi.#inner(this);
    const { xy, clearance, sites } = native.emptyCircles(checkedCount("count", count));
    return Array.from(clearance, (r, k) => ({
      lon: xy[2 * k]!,
      lat: xy[2 * k + 1]!,
      r,
      site: sites[k]!,
    }));
  }

  /**
   * The largest circle inside a cell: room for a label. r is at least 0.999 of the largest
   * possible, and the circle is inside but for rounding. null for a hidden site. Cost: some hundred
   * times O(d). Throws "no-convergence" for a cell that is thousands of times as long as wide.
   */
  cellCircle(id: number): SphericalCellCircle | null {
    const circle = SphericalVoronoi.#ofCell(this, id, (native, limit) =>
      native.cellCircle(id, limit),
    );
    return circleOrNull(circle);
  }

  /**
   * The largest circles inside all cells, in one array: longitude, latitude and r of site `id`
   * begin at 3 id; NaN for ids without a cell. Cost: that of `cellCircle` for each. Throws as that.
   */
  cellCircles(): Float64Array {
    const { native } = SphericalVoronoi.#inner(this);
    return circlesOf(native, SphericalVoronoi.#limits(this), 0, native.idLimit());
  }

  /**
   * `cellCircles` in slices of some milliseconds, with turns of the event loop between them.
   * Rejects as that throws; with the reason of `options.signal` once that aborts; with "busy" if
   * the diagram has changed meanwhile. A list or function of distances is asked once.
   */
  async cellCirclesAsync(options?: AsyncOptions): Promise<Float64Array> {
    const nativeNow = () => SphericalVoronoi.#inner(this).native;
    const count = nativeNow().idLimit();
    checkOptions(options, "signal", "onProgress");
    const limits = SphericalVoronoi.#limits(this);
    // awaited here, so that this view, and so the diagram, is not collected meanwhile
    return await circlesInSlices(
      options,
      count,
      () => nativeNow().revision(),
      (first, end) => circlesOf(nativeNow(), limits, first, end),
    );
  }

  // --- Interpolation -----------------------------------------------------------------------------

  /**
   * The natural neighbours of a place, for interpolation (Sibson): the sites from whose cells a new
   * site there would take a part, and the share of the new cell that comes from each. If a site
   * covers it, that one alone. The diagram stays as it is. null without sites, and where no cell is
   * within its maxDistance (shares are those of whole cells). Cost: location, and the size of what
   * would change.
   */
  naturalWeights(lon: number, lat: number, options?: InterpolationOptions): NaturalWeights | null {
    return naturalWeights(SphericalVoronoi.#asked(this), lon, lat, options);
  }

  /**
   * A field at many points: for each of the flat longitude, latitude pairs, what `naturalWeights`
   * says with the sites' `values`, which are given by id; NaN where that says null, and next to
   * sites whose value is NaN. Cost: as a loop of `naturalWeights`, without a call for each point.
   * Throws "bad-length" (lonLat; values, one for each id that was ever used, or for each site),
   * "unknown-site".
   */
  interpolate(
    values: NumbersById,
    lonLat: ArrayLike<number>,
    options?: InterpolationOptions,
  ): Float64Array {
    return interpolate(SphericalVoronoi.#asked(this), values, lonLat, options);
  }

  /**
   * `interpolate` in slices of some milliseconds, with turns of the event loop between them.
   * Rejects as that throws; with the reason of `options.signal` once that aborts; with "busy" if
   * the diagram has changed meanwhile.
   */
  async interpolateAsync(
    values: NumbersById,
    lonLat: ArrayLike<number>,
    options?: AsyncInterpolationOptions,
  ): Promise<Float64Array> {
    // awaited here, so that this view, and so the diagram, is not collected meanwhile
    return await interpolateAsync(SphericalVoronoi.#asked(this), values, lonLat, options);
  }

  // --- Measures ----------------------------------------------------------------------------------

  /** Area of a cell, in the square of the radius' unit; 0 for a hidden site. O(d). */
  cellArea(id: number): number {
    return SphericalVoronoi.#ofCell(this, id, (native, limit) => native.cellArea(id, limit));
  }

  /**
   * The mean of a cell's points, as a direction: longitude and latitude; the site's centre where
   * the mean has no direction, as of the whole sphere. null for a hidden site. O(d).
   */
  cellCentroid(id: number): Position | null {
    return SphericalVoronoi.#ofCell(this, id, (native, limit) => centroidOf(native, id, limit));
  }

  /** Length of a cell's boundary, in the radius' unit; 0 for a hidden site. O(d). */
  cellPerimeter(id: number): number {
    return SphericalVoronoi.#ofCell(this, id, (native, limit) => native.cellPerimeter(id, limit));
  }

  /** Area, centroid and perimeter at once. */
  cellMeasures(id: number): SphericalMeasures {
    return SphericalVoronoi.#ofCell(this, id, (native, limit) => ({
      area: native.cellArea(id, limit),
      centroid: centroidOf(native, id, limit),
      perimeter: native.cellPerimeter(id, limit),
    }));
  }

  /**
   * The areas of all cells by id, 0 for ids without a cell. Without a maxDistance they add up to
   * 4 π radius². O(n), faster than a loop. Throws "broken" if they do not, by a defect of the
   * library.
   */
  cellAreas(): Float64Array {
    const limits = SphericalVoronoi.#limits(this);
    return SphericalVoronoi.#inner(this).native.cellAreas(limits);
  }

  /**
   * The centroids of all cells: longitude at 2 id and latitude at 2 id + 1, NaN for a site
   * without a cell. O(n).
   */
  cellCentroids(): Float64Array {
    const limits = SphericalVoronoi.#limits(this);
    const { native } = SphericalVoronoi.#inner(this);
    const centroids = new Float64Array(2 * native.idLimit()).fill(NaN);
    for (const id of native.ids()) {
      const { lon, lat } = native.cellCentroid(id, limits[limits.length === 1 ? 0 : id]!);
      centroids.set([lon, lat], 2 * id);
    }
    return centroids;
  }

  /** The perimeters of all cells by id, 0 for ids without a cell. O(n). */
  cellPerimeters(): Float64Array {
    const limits = SphericalVoronoi.#limits(this);
    return SphericalVoronoi.#inner(this).native.cellPerimeters(limits);
  }

  // --- Shared parts ------------------------------------------------------------------------------

  static #inner(view: SphericalVoronoi): Inner<Native> {
    if (typeof view !== "object" || view === null || !(#limit in view)) throw wrongReceiver(view);
    return sphericalOf(view.diagram);
  }

  static #innerFor(view: SphericalVoronoi, id: number): Inner<Native> {
    const inner = SphericalVoronoi.#inner(view);
    withSite(inner.native, id);
    return inner;
  }

  /** How far all cells reach now: one distance for all, or by id. */
  static #limits(view: SphericalVoronoi): ArrayLike<number> {
    const limits = limitsOf(SphericalVoronoi.#inner(view), view.#limit);
    return typeof limits === "number" ? [limits] : limits;
  }

  /** Asks about a cell, with how far it reaches now. */
  static #ofCell<Answer>(
    view: SphericalVoronoi,
    id: number,
    ask: (native: Native, limit: number) => Answer,
  ): Answer {
    const inner = SphericalVoronoi.#innerFor(view, id);
    return ask(inner.native, limitOf(inner, view.#limit, id));
  }

  static #polygons(view: SphericalVoronoi, tolerance: number, isCut: boolean): CoverageArrays {
    const limits = SphericalVoronoi.#limits(view);
    return SphericalVoronoi.#inner(view).native.cellPolygons(limits, tolerance, isCut);
  }

  static #geometryOf(
    view: SphericalVoronoi,
    id: number,
    tolerance: number,
    isCut: boolean,
    winding: "counter-clockwise" | "clockwise",
  ): SphericalGeometry | null {
    return SphericalVoronoi.#ofCell(view, id, (native, limit) => {
      const rings = native.cellPolygon(id, tolerance, isCut, limit);
      const cells = Uint32Array.of(0, rings.parts.length - 1);
      if (cells[1] !== 0)
        return geometryOf({ ...rings, cells, sites: Uint32Array.of(id) }, 0, winding);
      return native.cellArea(id, limit) > 0 && native.cellPerimeter(id, limit) === 0
        ? { type: "Sphere" }
        : null;
    });
  }

  /** The parts of the view that interpolation needs. */
  static #asked(view: SphericalVoronoi): Asked<Native> {
    SphericalVoronoi.#inner(view);
    return {
      limit: view.#limit,
      innerNow: () => SphericalVoronoi.#inner(view),
      weights: (native, lon, lat, r) => {
        const found = native.naturalWeights(lon, lat, r);
        const count = found.length / 2;
        return { ids: Uint32Array.from(found.subarray(0, count)), weights: found.slice(count) };
      },
      values: (native, known, points, r) => native.interpolate(known, points, r),
    };
  }
}

function centroidOf(native: Native, id: number, limit: number): Position | null {
  const { lon, lat } = native.cellCentroid(id, limit);
  return Number.isNaN(lon) ? null : [lon, lat];
}

/** Is the only cell of these polygons the whole sphere, and not cut? */
function isSphere({ parts, sites }: CoverageArrays): boolean {
  return parts.length === 1 && sites.length > 0;
}

function noRing(id: number): ApolloniusError {
  return new ApolloniusError(
    "out-of-range",
    `the cell of site ${id} is the whole sphere, which has no ring: cellGeometry(${id}) says so`,
  );
}

function geometryOptions({ native }: Inner<Native>, options: SphericalGeometryOptions | undefined) {
  const winding = checkedWinding(options?.winding);
  const antimeridian = checkedChoice<"cut" | "keep">(
    "options.antimeridian",
    options?.antimeridian,
    winding === "clockwise" ? ["keep", "cut"] : ["cut", "keep"],
  );
  const tolerance = checkedTolerance(options, native.radius());
  return { winding, isCut: antimeridian === "cut", tolerance };
}

/** Longitude, latitude and r of the largest circles inside the cells of some ids; NaN for none. */
function circlesOf(
  native: Native,
  limits: ArrayLike<number>,
  first: number,
  end: number,
): Float64Array {
  const circles = new Float64Array(3 * (end - first)).fill(NaN);
  for (let id = first; id < end; ++id) {
    if (!native.has(id)) continue;
    const { lon, lat, r } = native.cellCircle(id, limits[limits.length === 1 ? 0 : id]!);
    circles.set([lon, lat, r], 3 * (id - first));
  }
  return circles;
}
