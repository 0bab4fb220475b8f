// The records that diagrams take and return.

/** A circle: centre and radius (weight), in the unit of the input. */
export interface Site {
  /** The centre's x. */
  x: number;
  /** The centre's y, which points upwards. */
  y: number;
  /** Radius, or weight; may be negative, as only differences matter to the diagram. */
  r: number;
}

/** A site with its id, as `for (const site of diagram)` gives it. */
export interface ListedSite extends Site {
  /** The site's id. */
  id: number;
  /** Whether its cell is empty, because another site covers it. */
  hidden: boolean;
}

/**
 * All sites, ascending by id; row k of each array belongs to the k-th of them. `xyr` is what
 * `new Diagram`, `insertMany` and `updateMany(ids, xyr)` take.
 */
export interface Sites {
  /** The ids. */
  ids: Uint32Array;
  /** x, y, r of each site, exactly as given. */
  xyr: Float64Array;
  /** 1 for a hidden site, 0 for one with a cell. */
  hidden: Uint8Array;
}

/**
 * The Voronoi vertices in the plane; row k of each array belongs to vertex k. The order of the rows
 * depends on the history.
 */
export interface Vertices {
  /** x, y of each vertex. */
  xy: Float64Array;
  /**
   * Common distance of each vertex to its three sites: the radius of the largest empty circle
   * there.
   */
  clearance: Float64Array;
  /** The three sites of each vertex, counter-clockwise. */
  sites: Uint32Array;
}

/**
 * The Voronoi edges; row k of each array belongs to edge k. Two sites can share several edges.
 * Where more than three sites touch one circle, the canonical rule makes edges of length zero, and
 * several vertices at one place.
 */
export interface Edges {
  /** The two sites of each edge. */
  sites: Uint32Array;
  /**
   * The two ends of each edge as rows of `vertices()`, -1 for an unbounded end. From the first end
   * to the second, the first site's cell is on the left.
   */
  vertices: Int32Array;
}

/** Options of the constructor of `Diagram`, of `from` and `insertMany`. */
export interface RadiusOption {
  /**
   * The radius (weight) of all sites: numbers are then pairs of coordinates, and only the
   * coordinates of items are read. Default: numbers are triples, and items have their own radii.
   */
  r?: number | undefined;
}

/** Options of `updateMany`. */
export interface UpdateOptions {
  /** As in `RadiusOption`; "keep": each site keeps its own. */
  r?: number | "keep" | undefined;
}

/** Options of calls that work in slices. */
export interface AsyncOptions {
  /** Ends the work when it aborts; the promise is rejected with its reason. */
  signal?: AbortSignal | undefined;
  /**
   * Called after each slice with the share that is done, from 0 to 1; the last call gets 1. It may
   * throw.
   */
  onProgress?: ((done: number) => void) | undefined;
}

/** Options of `Diagram.fromAsync`. */
export interface BuildOptions extends RadiusOption, AsyncOptions {}

/** Options of `Diagram.fromBytes`. */
export interface SnapshotOptions {
  /**
   * true: skip the verification, for unchanged bytes from `toBytes`. Default: false.
   */
  trusted?: boolean | undefined;
}

/** Options of `Diagram.fromBytesAsync`. */
export interface AsyncSnapshotOptions extends SnapshotOptions, AsyncOptions {}

/** Options of `within`, `search` and `farthest`. */
export interface FilterOptions {
  /**
   * Tells whether the site with that id counts: a site for which it returns a falsy value is left
   * out. It is called with ids, nearest first, until enough sites have passed. It may throw;
   * changing the diagram inside it throws "busy".
   *
   * Calls about many points ask it once a site, in any order. They cost a small multiple of a
   * search for each point, or of building a diagram of all sites that pass, whichever is less.
   */
  filter?: ((id: number) => unknown) | undefined;
}

/** Options of `find`, `nearest`, `findMany`, `nearestMany` and `kNearest`. */
export interface FindOptions extends FilterOptions {
  /**
   * The largest distance: sites that are farther are left out. Negative: the point must be at least
   * that deep inside the circle. Default: Infinity.
   */
  maxDistance?: number | undefined;
}

/** Options of `pick` and `pickMany`. */
export interface PickOptions extends FindOptions {
  /**
   * Which of several circles that contain the point is on top: "smallest" (default), where large
   * circles are drawn first (of equally large ones it is the nearest, as `find` has it); "last",
   * the one with the largest id, where all are drawn in that order.
   */
  top?: "smallest" | "last" | undefined;
}

/** Options of `withinMany`. */
export interface WithinManyOptions extends FilterOptions {
  /** Whether the result has distances. Default: false. */
  distances?: boolean | undefined;
}

/** Options of `kNearestMany`. */
export interface KNearestManyOptions extends FindOptions, WithinManyOptions {}

/** The site that a query has found for a point. */
export interface FoundSite {
  /** The id of the site. */
  id: number;
  /** Distance from the point to the site, rounded; for `farthest`, to the circle's far side. */
  distance: number;
}

/** The nearest site of each of several points. */
export interface NearestSites {
  /** The id of each point's nearest site, -1 where no site is found. */
  ids: Int32Array;
  /** The distance of each point to its site, Infinity where no site is found. */
  distances: Float64Array;
}

/**
 * The sites near each of several points: those of point k are `ids.subarray(starts[k],
 * starts[k + 1])`, nearest first. The arrays are those of a sparse matrix in compressed rows.
 */
export interface NearbyLists {
  /** All lists, one after the other. */
  ids: Uint32Array;
  /** Where each point's list begins in `ids`; one number more than there are points. */
  starts: Uint32Array;
  /** The distance of each site of `ids`, if asked for. */
  distances?: Float64Array;
}

/** x, y. */
export type Position = [x: number, y: number];

/** A window, xmin < xmax and ymin < ymax, in the diagram's unit. */
export type Bounds = readonly [xmin: number, ymin: number, xmax: number, ymax: number];
