import type { CellMoments, CoverageArrays } from "../../../build/wasm/apollonius.mjs";
import {
  checkedChoice,
  checkedCount,
  checkOptions,
  isSiteId,
  unknownSite,
} from "../core/arguments.js";
import type { Diagram } from "../core/diagram.js";
import { type Inner, nativeOf, planarOf, wrongReceiver } from "../core/inner.js";
import { showInWords } from "../core/inspection.js";
import { Ballast, destroy, keep } from "../core/native/lifetime.js";
import {
  type NativeReach,
  type NativeRegion,
  type NativeShapes,
  shapesOf,
} from "../core/native/module.js";
import { ofSite } from "../core/native/native_errors.js";
import { withSite } from "../core/space.js";
import { drawn, type DrawOptions, type PathContext, play } from "../core/path.js";
import type { Bounds, Edges, Position } from "../core/types.js";
import { ApolloniusError } from "../errors.js";
import { cellPaths, drawCells } from "./cell_paths.js";
import { joined, measuresOf, partsOf, type Rings, ringOf } from "./cell_shapes.js";
import { checkedAspect, circleOrNull, circlesInSlices } from "./circles.js";
import { drawBounds, drawInto, type NativeWindow, toleranceOf } from "./drawing.js";
import { isWithClearance, narrowestOf } from "./edges.js";
import { fitAreas, fitAreasAsync } from "./fit.js";
import {
  type CellGeometry,
  type CellMesh,
  type CellsCollection,
  checkedProperties,
  checkedWinding,
  featuresOf,
  type GeoJSONOptions,
  type GroupOptions,
  type GroupsCollection,
  groupFeaturesOf,
  groupsOf,
  type GeometryOptions,
  geometryOf,
  meshOf,
} from "./geojson.js";
import { type Asked, interpolate, interpolateAsync, naturalWeights } from "./interpolation.js";
import { checkedLimit, contains, limitOf, limitsOf } from "./limits.js";
import { createReach, createRegion } from "./native_window.js";
import { checkedProjection, readWindow, unprojected } from "./projection.js";
import type { WindowShape } from "./region.js";
import type {
  AreaTargets,
  AsyncCellCircleOptions,
  AsyncFitOptions,
  AsyncInterpolationOptions,
  CellCircle,
  CellCircleOptions,
  CellCurves,
  CellPolygon,
  CellRing,
  EdgeCurves,
  EdgeOptions,
  EdgesWithClearance,
  EmptyCircle,
  EmptyCircleOptions,
  FitOptions,
  FittedAreas,
  FlatOptions,
  InterpolationOptions,
  MaxDistance,
  Measures,
  NaturalWeights,
  NestedOptions,
  NumbersById,
  PolygonOptions,
  Projection,
  VerticesInside,
  VoronoiOptions,
  VoronoiWindow,
} from "./types.js";
import { windowOf } from "./window.js";

// A region stores a note for each face of the diagram: ten bytes a site, where Ballast counts 162.
const kRegionsOfSite = 16;

// Numbers of cells that a generator asks for in one call: few at first, so that it starts at once;
// at most some hundred kilobytes of points.
const [kFirstCells, kMostCells] = [256, 8192];

/** The window of a call, with the reach of cells during the call. */
interface Held {
  /** Called last: the caller's code may have disposed of the view before; then it throws. */
  windowNow(): NativeWindow;
  end(): void;
}

/**
 * The cells of a diagram inside a window, as shapes, measures and drawings:
 * `diagram.voronoi(bounds)`, or with a window of any shape, `diagram.voronoi(region)`. A view
 * always shows the diagram as it is now; do not change the diagram while a drawing calls the
 * context.
 *
 * Cells have curved edges, and everything is computed from these: drawings and polygons are within
 * a tolerance of them, measures are those of the curves. (So the areas of polygons are not exactly
 * those of cells: by default within 0.5 %, however small a cell is.) A clipped cell can be several
 * *parts* (if its site's centre is outside the window), which have holes where the window does.
 *
 * In a window that is not a rectangle, the first call after a change of the diagram finds where the
 * window's rings pass through the cells. That takes about O(n + (m + c) log d), m being their
 * points, c how often they go from cell to cell, and d the largest degree of a cell. (Sides that
 * are about as near to many cells as to the border of theirs cost that number each.) O(d) below is
 * then O(d + what of the rings is in the cell). The window is prepared once, in O(m log m).
 * `dispose` gives the memory back.
 *
 * Everywhere: an id without a site throws "unknown-site"; a hidden site, which has no cell, and a
 * cell with no part inside the window give nothing: null for places and shapes, 0 for areas and
 * lengths, NaN for coordinates in lists, nothing drawn. Options throw "not-finite" or
 * "out-of-range", unknown ones "bad-option", as does a context that cannot draw. Names and meaning
 * are d3-delaunay's where it has them.
 */
export class Voronoi implements Disposable {
  // --- The view ----------------------------------------------------------------------------------

  /** The diagram that is looked at. */
  readonly diagram: Diagram;
  /** Left border of the window. */
  readonly xmin: number;
  /** Lower border (y upwards). */
  readonly ymin: number;
  /** Right border. */
  readonly xmax: number;
  /** Upper border. */
  readonly ymax: number;
  /** The window itself: its area, its centroid, and which points it contains. */
  readonly window: VoronoiWindow;
  readonly #region: NativeRegion | null = null;
  /** How far cells reach. If it is a finite number, #reach holds it for the library. */
  readonly #limit: MaxDistance;
  readonly #reach: NativeReach | null = null;
  readonly #project: Projection | undefined;
  readonly #ballast: Ballast | null = null;
  #isDisposed = false;

  /** `diagram.voronoi(window)` makes it. */
  private constructor(diagram: Diagram, given: WindowShape, options?: VoronoiOptions) {
    const native = nativeOf(diagram);
    checkOptions(options, "maxDistance", "project");
    this.#project = checkedProjection(options?.project);
    const window = readWindow(given, this.#project);
    this.#limit = checkedLimit(options);
    let bounds: [number, number, number, number];
    if ("starts" in window) {
      const { coordinates, starts } = window;
      this.#region = createRegion(this, shapesOf(native), coordinates, starts);
      // When it is laid over the diagram, a region stores a note for each face.
      this.#ballast = new Ballast();
      this.#ballast.carry(native.size() / kRegionsOfSite);
      const box = this.#region.box();
      bounds = [box.xmin, box.ymin, box.xmax, box.ymax];
    } else {
      bounds = window;
    }
    if (typeof this.#limit === "number" && this.#limit !== Infinity)
      this.#reach = createReach(this, shapesOf(native), this.#limit);
    const [xmin, ymin, xmax, ymax] = bounds;
    this.diagram = diagram;
    this.xmin = xmin;
    this.ymin = ymin;
    this.xmax = xmax;
    this.ymax = ymax;
    this.window = windowOf(bounds, this.#region, () => Voronoi.#living(this));
    showInWords(this, `window: [${bounds.join(", ")}], `);
    Object.freeze(this); // else callers could put objects there, whose valueOf runs during calls
  }

  /** @internal For `diagram.voronoi(window)`. */
  static of(diagram: Diagram, window: WindowShape, options?: VoronoiOptions): Voronoi {
    return new Voronoi(diagram, window, options);
  }

  /** @internal Area and centroid in one call: for treemaps. */
  static momentsOf(view: Voronoi, id: number): CellMoments {
    return Voronoi.#moments(view, id);
  }

  // --- Saving ------------------------------------------------------------------------------------

  /** "Voronoi". */
  get [Symbol.toStringTag](): string {
    return "Voronoi";
  }

  // --- Drawing -----------------------------------------------------------------------------------

  /**
   * Draws all edges inside the window, each once; with a maxDistance also where cells end without a
   * neighbour. O(n).
   */
  render(context: PathContext, options?: DrawOptions): void;
  render(context?: null, options?: DrawOptions): string;
  render(context?: PathContext | null, options?: DrawOptions): string | void;
  render(context?: PathContext | null, options?: DrawOptions): string | void {
    Voronoi.#living(this);
    const tolerance = toleranceOf(options);
    return drawn(context, options, (target) =>
      Voronoi.#clipped(this, undefined, (native, windowNow) =>
        drawInto(target, native, "edges", windowNow, tolerance),
      ),
    );
  }

  /** Draws the window's border. Throws "out-of-range" (digits), "bad-option". */
  renderBounds(context: PathContext, options?: DrawOptions): void;
  renderBounds(context?: null, options?: DrawOptions): string;
  renderBounds(context?: PathContext | null, options?: DrawOptions): string | void;
  renderBounds(context?: PathContext | null, options?: DrawOptions): string | void {
    const native = Voronoi.#living(this);
    return drawn(context, options, (target) => drawBounds(target, native, this.#window));
  }

  /** Draws a cell as closed figures, one for each region. O(d log d). */
  renderCell(id: number, context: PathContext, options?: DrawOptions): void;
  renderCell(id: number, context?: null, options?: DrawOptions): string;
  renderCell(id: number, context?: PathContext | null, options?: DrawOptions): string | void;
  renderCell(id: number, context?: PathContext | null, options?: DrawOptions): string | void {
    Voronoi.#nativeFor(this, id);
    const tolerance = toleranceOf(options);
    return drawn(context, options, (target) => {
      const { commands, coordinates } = Voronoi.#clipped(this, [id], (native, windowNow) =>
        native.drawCell(...windowNow(), id, tolerance),
      );
      play(target, commands, coordinates);
    });
  }

  /**
   * All cells, drawn one after the other as `renderCell` draws them: `each(id)` fills or strokes
   * the cell that has just been drawn. Before each cell, `context.beginPath()` is called if the
   * context has it. Or, without a context, the paths of all cells by id: null for ids without a
   * cell in the window. Where `digits` is left open, the numbers of these have as many decimal
   * places as the tolerance needs, 2 for d3-delaunay's window of 960 x 500: rounding moves nothing
   * by more than an eighth of it. O(n), several times as fast as a loop.
   */
  renderCells(context: PathContext, each: (id: number) => void, options?: DrawOptions): void;
  renderCells(context?: null, options?: DrawOptions): (string | null)[];
  renderCells(
    context?: PathContext | null,
    given?: ((id: number) => void) | DrawOptions,
    options?: DrawOptions,
  ): (string | null)[] | void {
    return Voronoi.#clipped(this, undefined, (native, windowNow) =>
      context === null || context === undefined
        ? cellPaths(native, windowNow, given as DrawOptions | undefined)
        : drawCells(context, native, windowNow, given as (id: number) => void, options),
    );
  }

  // --- Shapes ------------------------------------------------------------------------------------

  /**
   * A cell as one closed ring, counter-clockwise (y upwards), within the tolerance of the true one.
   * Several parts, and holes, are joined by doubled segments, which have no area; `cellParts`
   * keeps them apart. By default its area is within 0.5 % of the cell's, whose own is `cellArea`.
   * O(d log d). Throws "not-finite", "out-of-range", "bad-option" (options).
   */
  cellPolygon(id: number, options: FlatOptions): Float64Array | null;
  cellPolygon(id: number, options?: NestedOptions): Position[] | null;
  cellPolygon(id: number, options?: PolygonOptions): CellRing | null;
  cellPolygon(id: number, options?: PolygonOptions): CellRing | null {
    return joined(Voronoi.#rings(this, id, options));
  }

  /**
   * The parts of a cell, each a list of closed rings: the outer one, counter-clockwise, and those
   * of its holes, clockwise. They are valid polygons, no two of whose segments cross. Errors and
   * cost as `cellPolygon`. Cells asked one by one may differ from their neighbours by rounding;
   * `toGeoJSON` is proved to tile the window.
   */
  cellParts(id: number, options: FlatOptions): Float64Array[][] | null;
  cellParts(id: number, options?: NestedOptions): Position[][][] | null;
  cellParts(id: number, options?: PolygonOptions): CellRing[][] | null;
  cellParts(id: number, options?: PolygonOptions): CellRing[][] | null {
    return partsOf(Voronoi.#rings(this, id, options));
  }

  /**
   * A cell as a geometry of GeoJSON, as `toGeoJSON` has those of all: null for a hidden site and
   * outside the window. Errors and cost as `cellPolygon`, and what may differ as in `cellParts`.
   */
  cellGeometry(id: number, options?: GeometryOptions): CellGeometry | null {
    Voronoi.#nativeFor(this, id);
    checkOptions(options, "tolerance", "winding");
    const winding = checkedWinding(options?.winding);
    const tolerance = toleranceOf(options);
    const rings = Voronoi.#clipped(this, [id], (native, windowNow) =>
      native.cellPolygon(...windowNow(), id, tolerance),
    );
    if (rings.parts.length < 2) return null;
    const cells = Uint32Array.of(0, rings.parts.length - 1);
    const polygons = Voronoi.#onMap(
      this,
      { ...rings, cells, sites: Uint32Array.of(id) },
      tolerance,
    );
    return geometryOf(polygons, 0, winding);
  }

  /**
   * The polygons of all cells that have a part in the window, ascending by id, which is their
   * `index`: as `cellPolygon` gives them, but found many at a time. If the diagram changes
   * meanwhile, the polygons that follow are those of the changed diagram, up to the id that was the
   * last one at the start; how far cells reach is asked at the start.
   */
  cellPolygons(options: FlatOptions): Generator<CellPolygon<Float64Array>, void>;
  cellPolygons(options?: NestedOptions): Generator<CellPolygon, void>;
  cellPolygons(options?: PolygonOptions): Generator<CellPolygon<CellRing>, void>;
  *cellPolygons(options?: PolygonOptions): Generator<CellPolygon<CellRing>, void> {
    Voronoi.#living(this);
    const { isFlat, tolerance } = ringOptions(options);
    const last = this.diagram.ids().at(-1) ?? -1;
    const isAsBefore = (revision: number) => Voronoi.#living(this).revision() === revision;
    const held = Voronoi.#hold(this);
    try {
      for (let id = 0, size = kFirstCells; id <= last; size = Math.min(2 * size, kMostCells)) {
        const native = Voronoi.#living(this);
        const [end, revision] = [Math.min(id + size, last + 1), native.revision()];
        const cells = native.cellPolygonsBetween(...held.windowNow(), id, end, tolerance);
        id = end;
        for (const [k, index] of cells.sites.entries()) {
          yield Object.assign(ringOf(cells, k, isFlat), { index });
          if (isAsBefore(revision)) continue;
          id = index + 1;
          break;
        }
      }
    } finally {
      held.end();
    }
  }

  /** The true boundary of a cell, as curves. */
  cellCurves(id: number): CellCurves | null {
    const { curves, sites, starts } = Voronoi.#clipped(
      this,
      Voronoi.#about(this, id),
      (native, windowNow) => native.cellCurves(...windowNow(), id),
    );
    return starts.length < 2 ? null : { curves, neighbors: new Int32Array(sites.buffer), starts };
  }

  /**
   * All edges inside the window, as curves, none that is but a point (see `neighbors`); one shorter
   * than doubles can tell begins and ends in one place. An edge of which the window cuts out a part
   * is several. O(n).
   */
  edgeCurves(): EdgeCurves {
    const { curves, sites } = Voronoi.#clipped(this, undefined, (native, windowNow) =>
      native.edgeCurves(...windowNow()),
    );
    return { curves, sites };
  }

  /**
   * The edges of `edgeCurves` as a graph: row k is the edge of curve k, between rows of
   * `vertices()`; no end is unbounded. With `clearance` also the narrowest place of each: of a road
   * or a pore. O(n). Throws "bad-option".
   */
  edges(options: EdgeOptions & { clearance: true }): EdgesWithClearance;
  edges(options?: EdgeOptions): Edges;
  edges(options?: EdgeOptions): Edges {
    const isClear = isWithClearance(options);
    const { edges, narrowest } = Voronoi.#edgeGraph(this);
    return isClear ? { ...edges, ...narrowestOf(narrowest) } : edges;
  }

  /**
   * The ends of these edges: the Voronoi vertices inside, and a vertex wherever an edge is cut, by
   * the border or by `maxDistance`. A vertex of more than three sites, which the diagram has
   * several times, is one. O(n).
   */
  vertices(): VerticesInside {
    const { vertices } = Voronoi.#edgeGraph(this);
    const { xy, clearance, sites } = vertices;
    return { xy, clearance, sites: new Int32Array(sites.buffer) };
  }

  /**
   * The edges between cells as lines of GeoJSON, each once, in the points that it has in the
   * polygons of `toGeoJSON`. The window's border, and boundaries at a maxDistance, which no
   * neighbour shares, are left out. Cost, errors: as `toGeoJSON`.
   */
  cellMesh(options?: Pick<GeometryOptions, "tolerance">): CellMesh {
    Voronoi.#living(this);
    checkOptions(options, "tolerance");
    return meshOf(Voronoi.#polygons(this, toleranceOf(options)));
  }

  /**
   * All cells as GeoJSON (RFC 7946), ascending by id: polygons with their holes, or multi-polygons
   * where a cell has several parts. Polygons are valid and tile the window: neighbours have the
   * points of their common boundary in common, whatever the tolerance. Coordinates are the
   * diagram's own, or those of the map if the view has a projection (`VoronoiOptions.project`).
   * `options.properties` may throw.
   *
   * With `options.group` cells that belong together are one feature: of the shops of a chain, or of
   * samples along a line. Borders between cells of one group are left out; groups tile what their
   * cells do, and have the points of their common boundary in common. O(n log n).
   */
  toGeoJSON<Key, Properties = { group: Key }>(
    options: GroupOptions<Key, Properties>,
  ): GroupsCollection<Key, Properties>;
  toGeoJSON<Properties = { site: number }>(
    options?: GeoJSONOptions<Properties>,
  ): CellsCollection<Properties>;
  toGeoJSON<Key, Properties>(
    options?: GroupOptions<Key, Properties> | GeoJSONOptions<Properties>,
  ): GroupsCollection<Key, Properties> | CellsCollection<Properties> {
    Voronoi.#living(this);
    checkOptions(options, "tolerance", "properties", "winding", "group");
    const winding = checkedWinding(options?.winding);
    const tolerance = toleranceOf(options);
    if (options && "group" in options && options.group !== undefined) {
      const groups = groupsOf(this.diagram.ids(), options);
      const polygons = Voronoi.#polygons(this, tolerance, groups.numbers);
      return groupFeaturesOf(polygons, groups, winding);
    }
    const properties = checkedProperties<Properties>(options?.properties);
    return featuresOf(Voronoi.#polygons(this, tolerance), properties, winding);
  }

  // --- Points and neighbours ---------------------------------------------------------------------

  /**
   * Is this site the nearest one to the point, and within the view's maxDistance? That is
   * `diagram.find(x, y, { maxDistance }) === id`: exact, ties as there; the window does not matter.
   * false for a hidden site. Throws "unknown-site", "not-finite", "out-of-range".
   */
  contains(id: number, x: number, y: number): boolean {
    Voronoi.#nativeFor(this, id);
    return contains(Voronoi.#inner(this), this.#limit, id, x, y);
  }

  /**
   * The sites whose cells have an edge in common with this one's inside the window,
   * counter-clockwise, each once. An edge has a length, however small: cells that meet in a point
   * only are no neighbours, and `diagram.neighbors` may have them. That is decided exactly at
   * Voronoi vertices, and up to rounding where the window or a maxDistance ends an edge; of two
   * neighbours each has the other, and `edgeCurves` the edge. O(d log d).
   */
  neighbors(id: number): Uint32Array {
    return Voronoi.#clipped(this, Voronoi.#about(this, id), (native, windowNow) =>
      native.cellNeighbors(...windowNow(), id),
    );
  }

  // --- Empty circles, and room for labels --------------------------------------------------------

  /**
   * The largest circle that no site's circle reaches into, with its centre in the window: the place
   * that is farthest from all sites, at a Voronoi vertex, where an edge crosses the border, or at a
   * corner. null without sites. The choice among these is by their distances as rounded, which are
   * right up to the last places of the coordinates. A maxDistance does not matter. O(n log n).
   *
   * With `inside`, the largest such circle that does not cross the window's border: r is at least
   * 0.999 of the largest possible. Cost: also that of `cellCircle` for each cell at the border that
   * is searched, few of them for one circle. Throws "bad-option"; "no-convergence" if sides that
   * nearly coincide keep the search from ending.
   */
  largestEmptyCircle(options?: EmptyCircleOptions): EmptyCircle | null {
    Voronoi.#living(this);
    return this.emptyCircles(1, options)[0] ?? null;
  }

  /**
   * The `count` largest of such circles, the largest first, none with its centre in one before it:
   * where to put new sites apart from each other. Fewer if there are no more. A maxDistance
   * does not matter. With `inside`, these are chosen from: the circles about Voronoi vertices that
   * do not cross the border, and the largest one of each cell at the border; so there may be room
   * for more. Throws "not-finite", "out-of-range" (count), "bad-option",
   * "no-convergence". O(n (log n + count)).
   */
  emptyCircles(count: number, options?: EmptyCircleOptions): EmptyCircle[] {
    Voronoi.#living(this);
    const most = checkedCount("count", count);
    checkOptions(options, "inside");
    const inside = checkedChoice("options.inside", options?.inside, [false, true]);
    const native = Voronoi.#living(this);
    const { xy, clearance, sites } = native.emptyCircles(...this.#window, most, inside);
    return Array.from(clearance, (r, k) => ({
      x: xy[2 * k]!,
      y: xy[2 * k + 1]!,
      r,
      site: sites[k]!,
    }));
  }

  /**
   * The largest circle inside a cell: room for a label. r is at least 0.999 of the largest
   * possible, and the circle is inside the curved cell but for rounding. null if no part of the
   * cell is in the window. With `aspect`, the largest ellipse that is as many times as wide as
   * high, for text: r is half its height. Cost: O(d log d), some ten times that of `cellCurves`.
   * Throws "not-finite", "out-of-range" (aspect), "bad-option"; "no-convergence" if sides that
   * nearly coincide keep the search from ending.
   */
  cellCircle(id: number, options?: CellCircleOptions): CellCircle | null {
    Voronoi.#nativeFor(this, id);
    const aspect = checkedAspect(options);
    return circleOrNull(
      Voronoi.#clipped(this, [id], (native, windowNow) =>
        native.cellCircle(...windowNow(), id, aspect),
      ),
    );
  }

  /**
   * The largest circles inside all cells, in one array: the x, y and r of site `id` begin at 3 id.
   * They are NaN for ids without a cell in the window. Cost: that of `cellCircle` for each cell.
   * Throws "not-finite", "out-of-range" (aspect), "bad-option", "no-convergence".
   */
  cellCircles(options?: CellCircleOptions): Float64Array {
    Voronoi.#living(this);
    const aspect = checkedAspect(options);
    return Voronoi.#clipped(this, undefined, (native, windowNow) =>
      native.cellCirclesBetween(...windowNow(), 0, native.idLimit(), aspect),
    );
  }

  /**
   * `cellCircles` in slices of some milliseconds, with turns of the event loop between them.
   * Rejects as that throws; with the reason of `options.signal` once that aborts; with "busy" if
   * the diagram has changed meanwhile. A list or function of distances is asked once.
   */
  async cellCirclesAsync(options?: AsyncCellCircleOptions): Promise<Float64Array> {
    Voronoi.#living(this);
    const aspect = checkedAspect(options, "signal", "onProgress");
    const held = Voronoi.#hold(this);
    try {
      // awaited here, so that this view, and so the diagram, is not collected meanwhile
      return await circlesInSlices(
        options,
        Voronoi.#living(this).idLimit(),
        () => Voronoi.#living(this).revision(),
        (first, end) =>
          Voronoi.#living(this).cellCirclesBetween(...held.windowNow(), first, end, aspect),
      );
    } finally {
      held.end();
    }
  }

  // --- Interpolation -----------------------------------------------------------------------------

  /**
   * The natural neighbours of a place, for interpolation (Sibson): the sites from whose cells in
   * the window a new circle there would take a part, and the share of the new cell that comes from
   * each. If a circle covers it, that one alone. The value of a field at the place is the sum of
   * weights times values. It is continuous, and exact at the centres of sites, if r is at most the
   * smallest radius. The diagram stays as it is. null without sites, where the new cell would have
   * no part in the window, and where no cell is within its maxDistance (shares are those of whole
   * cells). Cost: location, and the size of what would change; at the border of a window that is no
   * rectangle also O(its points) and a diagram of the natural neighbours. Throws "not-finite",
   * "out-of-range", "bad-option".
   */
  naturalWeights(x: number, y: number, options?: InterpolationOptions): NaturalWeights | null {
    return naturalWeights(Voronoi.#asked(this), x, y, options);
  }

  /**
   * A field at many points: for each of the flat x, y pairs, what `naturalWeights` says with the
   * sites' `values`, which are given by id. NaN where that says null, and next to sites whose value
   * is NaN. Among sites that are points, a linear field is reproduced wherever
   * the cell of a new point would end within the window. Cost: as a loop of `naturalWeights`, but
   * without location, and without a call for each point. Throws "bad-length" (xy; values, one for
   * each id that was ever used, or for each site), "unknown-site", "not-finite", "out-of-range",
   * "bad-option".
   */
  interpolate(
    values: NumbersById,
    xy: ArrayLike<number>,
    options?: InterpolationOptions,
  ): Float64Array {
    return interpolate(Voronoi.#asked(this), values, xy, options);
  }

  /**
   * `interpolate` in slices of some milliseconds, with turns of the event loop between them.
   * Rejects as that throws; with the reason of `options.signal` once that aborts; with "busy" if
   * the diagram has changed meanwhile.
   */
  async interpolateAsync(
    values: NumbersById,
    xy: ArrayLike<number>,
    options?: AsyncInterpolationOptions,
  ): Promise<Float64Array> {
    // awaited here, so that this view, and so the diagram, is not collected meanwhile
    return await interpolateAsync(Voronoi.#asked(this), values, xy, options);
  }

  // --- Measures ----------------------------------------------------------------------------------

  /** Area of a cell inside the window; 0 for a hidden site. */
  cellArea(id: number): number {
    return Voronoi.#moments(this, id).area;
  }

  /** Centroid of a cell inside the window; null if no part of it is. */
  cellCentroid(id: number): Position | null {
    const { centroidX, centroidY, isEmpty } = Voronoi.#moments(this, id);
    return isEmpty ? null : [centroidX, centroidY];
  }

  /**
   * Length of the boundary of a cell inside the window, the window's border included; 0 for a
   * hidden site.
   */
  cellPerimeter(id: number): number {
    return Voronoi.#ofCell(this, id, (native, windowNow) => native.cellMeasures(...windowNow(), id))
      .perimeter;
  }

  /** Area, centroid and perimeter at once; the centroid is null if no part is in the window. */
  cellMeasures(id: number): Measures {
    return measuresOf(
      Voronoi.#ofCell(this, id, (native, windowNow) => native.cellMeasures(...windowNow(), id)),
    );
  }

  /**
   * The areas of all cells inside the window: element k is that of site k, 0 if that has no cell
   * there. Without a maxDistance they add up to the window's. O(n), much faster than a loop. Their
   * last places depend on the diagram's history, as do those of the next two and of `render`; those
   * of `cellArea` and of all else do not.
   */
  cellAreas(): Float64Array {
    return Voronoi.#clipped(this, undefined, (native, windowNow) =>
      native.cellAreas(...windowNow()),
    );
  }

  /**
   * The centroids of all cells inside the window: x at 2 id and y at 2 id + 1, NaN for a site that
   * has no cell there. O(n).
   */
  cellCentroids(): Float64Array {
    return Voronoi.#clipped(this, undefined, (native, windowNow) =>
      native.cellCentroids(...windowNow()),
    );
  }

  /** The perimeters of all cells inside the window, in the order of `cellAreas`. O(n). */
  cellPerimeters(): Float64Array {
    return Voronoi.#clipped(this, undefined, (native, windowNow) =>
      native.cellPerimeters(...windowNow()),
    );
  }

  // --- Prescribed areas --------------------------------------------------------------------------

  /**
   * Changes the weights of all sites so that the areas of their cells inside the window are in
   * proportion to targets. Centres stay, and hidden sites get a cell, too. `onIteration` may throw
   * to stop it.
   *
   * No two sites may share a centre, and with equal weights each must have a cell in the window, as
   * it does if its centre is inside. All or nothing: the diagram changes at the end, and only if
   * the tolerance is met, or if only rounding keeps the error above it (`converged` is then false).
   * Throws "bad-length", "unknown-site", "bad-target", "bad-option", "not-finite", "out-of-range",
   * "busy", and "no-convergence", which says what was reached. Cost: for each of some 20 steps
   * (several times that, where targets differ by orders of magnitude) about that of building the
   * diagram and of `cellAreas`.
   */
  fitAreas(targets: AreaTargets, options?: FitOptions): FittedAreas {
    return fitAreas(Voronoi.#living(this, true), () => this.#filled, targets, options);
  }

  /**
   * `fitAreas` in slices of some milliseconds, with turns of the event loop between them; no step
   * is divided. What fits into the first slice is done before the call returns its promise. Rejects
   * as that throws; with the reason of `options.signal` once that aborts; with "busy" if the
   * diagram has changed meanwhile.
   */
  async fitAreasAsync(targets: AreaTargets, options?: AsyncFitOptions): Promise<FittedAreas> {
    // awaited here, so that this view, and so the diagram, is not collected meanwhile
    return await fitAreasAsync(Voronoi.#living(this, true), () => this.#filled, targets, options);
  }

  // --- Lifetime ----------------------------------------------------------------------------------

  /**
   * Frees what a window that is not a rectangle has in memory: where it meets cells, and up to 10
   * bytes for each of the diagram's sites. Later calls throw "disposed". A forgotten view is freed
   * as a forgotten diagram is. The diagram lives on. O(1).
   */
  dispose(): void {
    if (this.#isDisposed) return;
    this.#isDisposed = true;
    if (this.#region !== null) destroy(this.#region);
    if (this.#reach !== null) destroy(this.#reach);
    this.#ballast?.drop();
  }

  /** `dispose`, for `using view = diagram.voronoi(region)`. O(1). */
  [Symbol.dispose](): void {
    this.dispose();
  }

  // --- Shared parts ------------------------------------------------------------------------------

  get #bounds(): Bounds {
    return [this.xmin, this.ymin, this.xmax, this.ymax];
  }

  /** The window for a native call. Read it last: the caller's code may dispose of the view. */
  get #window(): NativeWindow {
    Voronoi.#living(this);
    return [this.#region, this.#reach, ...this.#bounds];
  }

  /** The window of a fit. Throws "bad-option". */
  get #filled(): NativeWindow {
    if (this.#limit === Infinity) return this.#window;
    throw new ApolloniusError(
      "bad-option",
      "fitAreas is for cells that fill the window, not for those that end at a distance",
    );
  }

  /** Returns the diagram's inside; throws "busy" within a filter if the call `changes` it. */
  static #inner(view: Voronoi, changes = false): Inner<NativeShapes> {
    if (typeof view !== "object" || view === null || !(#isDisposed in view))
      throw wrongReceiver(view);
    if (view.#isDisposed) throw new ApolloniusError("disposed", "the view has been disposed of");
    const inner = planarOf(view.diagram, changes);
    shapesOf(inner.native);
    return inner as Inner<NativeShapes>;
  }

  static #living(view: Voronoi, changes = false): NativeShapes {
    return Voronoi.#inner(view, changes).native;
  }

  /** Asks now how far the cells of some sites reach, or of all, and keeps it until `end()`. */
  static #hold(view: Voronoi, ids?: readonly number[]): Held {
    const inner = Voronoi.#inner(view);
    const limit = view.#limit;
    if (typeof limit === "number") return { windowNow: () => view.#window, end() {} };
    const limits =
      ids?.map((id) => limitOf(inner, limit, id)) ?? (limitsOf(inner, limit) as Float64Array);
    const reach = Voronoi.#living(view).reach(limits, ids ?? []) as NativeReach;
    const held: Held = {
      windowNow: () => {
        Voronoi.#living(view);
        return [view.#region, reach, ...view.#bounds];
      },
      end: () => destroy(reach),
    };
    keep(held, reach);
    return held;
  }

  static #edgeGraph(view: Voronoi) {
    return Voronoi.#clipped(view, undefined, (native, windowNow) =>
      native.edgeGraph(...windowNow()),
    );
  }

  /** Asks about some cells, or about all, in the window as it is now. */
  static #clipped<Answer>(
    view: Voronoi,
    ids: readonly number[] | undefined,
    ask: (native: NativeShapes, windowNow: () => NativeWindow) => Answer,
  ): Answer {
    const held = Voronoi.#hold(view, ids);
    try {
      return ask(Voronoi.#living(view), held.windowNow);
    } finally {
      held.end();
    }
  }

  /** Returns a site and the sites that may share an edge with it, ascending. */
  static #about(view: Voronoi, id: number): number[] {
    const native = Voronoi.#nativeFor(view, id);
    if (typeof view.#limit === "number") return [id];
    return [id, ...native.neighbors(id)].sort((a, b) => a - b);
  }

  /** The parts of the view that interpolation needs. */
  static #asked(view: Voronoi): Asked<NativeShapes> {
    Voronoi.#living(view);
    return {
      limit: view.#limit,
      innerNow: () => Voronoi.#inner(view),
      weights: (native, x, y, r) => native.naturalWeights(...view.#window, x, y, r),
      values: (native, known, points, r) => native.interpolate(...view.#window, known, points, r),
    };
  }

  static #nativeFor(view: Voronoi, id: number): NativeShapes {
    return withSite(Voronoi.#living(view), id);
  }

  static #moments(view: Voronoi, id: number): CellMoments {
    return Voronoi.#ofCell(view, id, (native, windowNow) => native.cellMoments(...windowNow(), id));
  }

  /** Calls the library about a cell. */
  static #ofCell<Moments extends CellMoments>(
    view: Voronoi,
    id: number,
    call: (native: NativeShapes, windowNow: () => NativeWindow) => Moments,
  ): Moments {
    const native = Voronoi.#living(view);
    if (!isSiteId(id)) throw unknownSite(id);
    if (typeof view.#limit !== "number") {
      withSite(native, id);
      return Voronoi.#clipped(view, [id], call);
    }
    try {
      return call(native, () => view.#window);
    } catch (error) {
      throw ofSite(error, id);
    }
  }

  /** Returns the polygons of all cells, or of groups; projected back if the view has a map. */
  static #polygons(
    view: Voronoi,
    tolerance: number,
    groups: Uint32Array = kUngrouped,
  ): CoverageArrays {
    const polygons = Voronoi.#clipped(view, undefined, (native, windowNow) =>
      native.cellPolygons(...windowNow(), tolerance, groups),
    );
    return Voronoi.#onMap(view, polygons, tolerance);
  }

  static #onMap(view: Voronoi, polygons: CoverageArrays, tolerance: number): CoverageArrays {
    if (!view.#project) return polygons;
    const inMap = tolerance || Voronoi.#living(view).defaultTolerance(...view.#bounds);
    return unprojected(polygons, view.#project, inMap);
  }

  /** Returns the rings of a cell, one after the other. */
  static #rings(view: Voronoi, id: number, options: PolygonOptions | undefined): Rings {
    Voronoi.#nativeFor(view, id);
    const { isFlat, tolerance } = ringOptions(options);
    const rings = Voronoi.#clipped(view, [id], (native, windowNow) =>
      native.cellPolygon(...windowNow(), id, tolerance),
    );
    return { isFlat, ...rings };
  }
}

const kUngrouped = new Uint32Array(0);

function ringOptions(options: PolygonOptions | undefined) {
  checkOptions(options, "tolerance", "flat");
  const isFlat = checkedChoice("options.flat", options?.flat, [false, true]);
  return { isFlat, tolerance: toleranceOf(options) };
}
