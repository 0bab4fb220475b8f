// The types that the calls of Voronoi take and return.
import type { DrawOptions } from "../core/path.js";
import type { AsyncOptions, Bounds, Edges, Position, Vertices } from "../core/types.js";

// --- Fits, windows, questions --------------------------------------------------------------------

/** The progress of `fitAreas`. */
export interface FitProgress {
  /** Steps so far. */
  iterations: number;
  /**
   * The largest relative error of an area, against its target. It need not fall with each step.
   */
  error: number;
}

/**
 * A number for each site: an array by id, with one element for each id that was ever used (those
 * without a site are ignored); or a Map, or an object, of the sites' ids.
 */
export type NumbersById =
  | ArrayLike<number>
  | ReadonlyMap<number, number>
  | { readonly [id: number]: number };

/** The areas of all cells, in any unit, each above 0. */
export type AreaTargets = NumbersById;

/** The parts that a new site would take from other cells, as `naturalWeights` returns them. */
export interface NaturalWeights {
  /** The natural neighbours. */
  ids: Uint32Array;
  /** The share of each in the new cell; together 1. */
  weights: Float64Array;
}

/** A circle that no site's circle reaches into. */
export interface EmptyCircle {
  /** Its centre. */
  x: number;
  /** Its centre (y upwards). */
  y: number;
  /** The distance to the nearest site; below 0 where all of the window is covered. */
  r: number;
  /** The id of a site at that distance. */
  site: number;
}

/** Options of `largestEmptyCircle` and `emptyCircles`. */
export interface EmptyCircleOptions {
  /** true: no circle crosses the window's border. Default: false, only centres are inside. */
  inside?: boolean | undefined;
}

/** The largest circle inside a cell, or ellipse. */
export interface CellCircle {
  /** Its centre. */
  x: number;
  /** Its centre (y upwards). */
  y: number;
  /** Its radius; of an ellipse half its height. */
  r: number;
}

/** Options of `cellCircle` and `cellCircles`. */
export interface CellCircleOptions {
  /** Width divided by height of an ellipse, from 1/1000 to 1000. Default: 1, a circle. */
  aspect?: number | undefined;
}

/** Options of `cellCirclesAsync`. */
export interface AsyncCellCircleOptions extends CellCircleOptions, AsyncOptions {}

/** The smallest circle around all circles. */
export interface EnclosingCircle {
  /** Its centre. */
  x: number;
  /** Its centre (y upwards). */
  y: number;
  /** Its radius. */
  r: number;
  /** The ids of the sites that touch it from inside, ascending. */
  sites: Uint32Array;
}

/**
 * The window that cells are clipped to, `voronoi.window`. Of a region that is what is inside by the
 * even-odd rule, holes left out. Frozen; measures are computed when the view is made.
 */
export interface VoronoiWindow {
  /** The smallest box that holds it. */
  readonly bounds: Bounds;
  /** Its area, above 0, in the square of the diagram's unit: what `cellAreas` adds up to. */
  readonly area: number;
  /** Its centroid. */
  readonly centroid: readonly [x: number, y: number];
  /**
   * Is a point inside, or on the border? Exact for the rings that `renderBounds` draws: where the
   * given ones cross, these have the crossing as rounded. O(1), or O(m) for a region of m points.
   * Throws "not-finite", "out-of-range", and "disposed" once the view or the diagram is.
   */
  contains(x: number, y: number): boolean;
}

/**
 * How far from its site's circle a cell ends: one distance for all; an array by id, a Map or an
 * object of the sites' ids; or a function of an id.
 */
export type MaxDistance = number | NumbersById | ((id: number) => number);

/** Options of a view, of the plane and of the sphere. */
export interface ViewOptions {
  /**
   * Cells end at this distance from their sites' circles, in the unit of the coordinates or of the
   * sphere's radius. 0 is the circle itself, a negative distance is inside it, Infinity (the
   * default) is nowhere. A point at that distance is in the cell.
   *
   * Lists and functions are asked at each call: those about one cell ask for its site, `neighbors`
   * and `cellCurves` also for its neighbours, all others for all sites; generators and asynchronous
   * calls when they begin. A list must have all that is asked for ("bad-option"), and what it gives
   * must be a number ("not-finite", "out-of-range"). Changing the diagram meanwhile throws "busy".
   */
  maxDistance?: MaxDistance | undefined;
}

/** Options of `diagram.voronoi(window, options)`. */
export interface VoronoiOptions extends ViewOptions {
  /**
   * For a diagram of projected places: the window is given in longitude and latitude, bounds as
   * [west, south, east, north], and `toGeoJSON` gives its polygons in these. Sides are refined, so
   * that straight lines there are within the tolerance on the map. (At a coarse one, rings of thin
   * cells may cross.) All other calls stay in the diagram's plane.
   */
  project?: Projection | undefined;
}

/** From longitude and latitude to the plane and back, as d3-geo's projections; null is nowhere. */
export interface Projection {
  /** From [longitude, latitude] to [x, y]. */
  (place: Position): Position | null;
  /** From [x, y] to [longitude, latitude]. */
  invert(point: Position): Position | null;
}

/** The result of `fitAreas`. */
export interface FittedAreas extends FitProgress {
  /**
   * Whether `error` is within the tolerance. If it is not, the weights are right up to their last
   * places, and `error` is what rounding leaves.
   */
  converged: boolean;
  /** Why it has not converged. */
  reason?: string;
  /** The new weights, by id; NaN for ids without a site. */
  weights: Float64Array;
}

/** Options of `naturalWeights` and `interpolate`. */
export interface InterpolationOptions {
  /** Radius or weight of the new sites, whose natural neighbours are asked for. Default: 0. */
  r?: number | undefined;
}

/** Options of `interpolateAsync`. */
export interface AsyncInterpolationOptions extends InterpolationOptions, AsyncOptions {}

/** Options of `fitAreas`. */
export interface FitOptions {
  /** The search ends when `error` is at most this, > 0. Default: 1e-6. */
  tolerance?: number | undefined;
  /** Most steps. Default: 300. */
  maxIterations?: number | undefined;
  /**
   * true: throw "no-convergence" where only rounding keeps `error` above the tolerance. Default:
   * false.
   */
  strict?: boolean | undefined;
  /**
   * Weights to start from, by id; default: equal ones. From those of nearly the same targets or
   * centres it takes two or three steps. If some cell is empty with them, they are left aside.
   */
  start?: ArrayLike<number> | undefined;
  /**
   * Called after each step. It may throw, which stops the search, and the diagram stays as it is.
   * It may not change the diagram.
   */
  onIteration?: ((progress: FitProgress) => void) | undefined;
}

/** Options of `fitAreasAsync`. */
export interface AsyncFitOptions extends FitOptions, AsyncOptions {
  /**
   * Called after each slice with the share that is done, from 0 to 1, which never falls: how far
   * the least `error` so far has come from the first one to the tolerance, by orders of magnitude.
   * It does not tell how many steps are left. The last call gets 1, before the diagram changes. It
   * may throw.
   */
  onProgress?: ((done: number) => void) | undefined;
}

// --- Shapes --------------------------------------------------------------------------------------

/**
 * Curves as they are: each a rational quadratic Bezier curve, seven numbers x0, y0, x1, y1, w, x2,
 * y2 for
 *
 *     P(t) = ((1-t)² P0 + 2 w t (1-t) P1 + t² P2) / ((1-t)² + 2 w t (1-t) + t²),   0 <= t <= 1
 *
 * A piece of a hyperbola (w > 1) is exactly that; w is 0 for a straight segment, of which P1 is the
 * middle. P1 is where the tangents at P0 and P2 meet.
 */
export interface EdgeCurves {
  /** The curves, one after the other. */
  curves: Float64Array;
  /** The two sites of each curve; the first one's cell is on the left from P0 to P2. */
  sites: Uint32Array;
}

/** Options of `edges`. */
export interface EdgeOptions {
  /**
   * true: with the smallest clearance on each edge, and where that is: the width of the gap between
   * two circles. Default: false.
   */
  clearance?: boolean | undefined;
}

/** `edges({ clearance: true })`; row k of each array belongs to edge k. */
export interface EdgesWithClearance extends Edges {
  /**
   * The smallest distance of each edge to its two sites: half of the gap between the circles if the
   * edge passes between them, else the clearance of an end.
   */
  clearance: Float64Array;
  /** x, y of the place on each edge where that is. */
  xy: Float64Array;
}

/** The vertices of the edges inside a window; row k of each array belongs to vertex k. */
export interface VerticesInside extends Omit<Vertices, "sites"> {
  /**
   * Three sites of each vertex, counter-clockwise. Where the window or a distance cuts an edge, the
   * two sites of that, and -1.
   */
  sites: Int32Array;
}

/**
 * The boundary of a cell inside the window, ring by ring: counter-clockwise, and those of holes
 * clockwise behind the one around them.
 */
export interface CellCurves {
  /** The curves, one after the other. */
  curves: Float64Array;
  /** The site on the other side of each curve; -1 along the border of the window. */
  neighbors: Int32Array;
  /** The first curve of each ring, and the number of curves at the end. */
  starts: Uint32Array;
}

/** Measures of a true curved cell, in the diagram's unit. */
export interface Measures {
  /** Area; 0 if no part of the cell is inside. */
  area: number;
  /** Centroid; null if the area is 0. */
  centroid: Position | null;
  /** Length of the boundary, the window's parts included. */
  perimeter: number;
}

/** A closed ring [x, y], …, its first point repeated at the end; or flat x, y, …. */
export type CellRing = Position[] | Float64Array;

/** The polygon of a cell, with the id of its site. */
export type CellPolygon<Points extends CellRing = Position[]> = Points & { index: number };

/** Options of `cellPolygon`, `cellPolygons` and `cellParts`. */
export interface PolygonOptions {
  /** As in `DrawOptions`. */
  tolerance?: number | undefined;
  /**
   * true: rings are x, y, … in one Float64Array, which is faster. Default: false, [x, y], …, as
   * d3-delaunay has it.
   */
  flat?: boolean | undefined;
}

/** `PolygonOptions` for flat rings. */
export type FlatOptions = PolygonOptions & { flat: true };
/** `PolygonOptions` for rings of pairs. */
export type NestedOptions = PolygonOptions & { flat?: false | undefined };

/** Options of `Diagram.render`: with bounds also the rays of the sites on the hull. */
export interface DualOptions extends DrawOptions {
  /** How far the rays go; none without. */
  bounds?: Bounds | undefined;
}
