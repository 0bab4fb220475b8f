// Windows, drawings and the enclosing circle as methods of Diagram: what the default entry adds to
// that of `apollonius-diagram/core`, which is the same class. The types are the default entry's
// own: who imports only core is not promised what is not there.
import type { Accessor, Circular, Items } from "../core/accessors.js";
import { Diagram as Core } from "../core/diagram.js";
import type { DrawOptions, PathContext } from "../core/path.js";
import type {
  AsyncSnapshotOptions,
  BuildOptions,
  Edges,
  RadiusOption,
  SnapshotOptions,
} from "../core/types.js";
import {
  edges,
  render,
  renderHull,
  renderSites,
  smallestEnclosingCircle,
  voronoi,
} from "./functions.js";
import type { WindowShape } from "./region.js";
import type {
  DualOptions,
  EdgeOptions,
  EdgesWithClearance,
  EnclosingCircle,
  VoronoiOptions,
} from "./types.js";
import type { Voronoi as View } from "./voronoi.js";

/** The cells of a diagram inside a window; `apollonius-diagram/shapes` describes it. */
export interface Voronoi extends View {
  /** The diagram that is looked at. */
  readonly diagram: Diagram;
}

/** The diagram of `apollonius-diagram/core` with windows, drawings and the enclosing circle. */
export interface Diagram extends Core {
  // --- Cells and drawings ------------------------------------------------------------------------

  /**
   * The cells inside a window: a view, always of the diagram as it is now. The default window is
   * d3-delaunay's, 960 x 500. A window of any shape is rings or GeoJSON (`Region`), or a disc
   * { x, y, r }. Cost: O(1), or O(m log m) for a region of m points. Throws "bad-bounds",
   * "bad-option"; of a maxDistance "not-finite", "out-of-range".
   */
  voronoi(window?: WindowShape, options?: VoronoiOptions): Voronoi;

  /**
   * All Voronoi edges; with `clearance` also the smallest clearance on each, and where that is.
   * O(n). Throws "bad-option".
   */
  edges(options: EdgeOptions & { clearance: true }): EdgesWithClearance;
  edges(options?: EdgeOptions): Edges;

  /**
   * Draws the dual graph as the paper's Appendix A embeds it: each Delaunay edge as a piece of a
   * hyperbola or parabola or as a segment between the two centres, such that no two cross. With
   * `bounds` also the rays of the sites on the hull, up to that window. Returns an SVG path
   * string if there is no context. O(n). Throws "bad-bounds", "not-finite", "out-of-range",
   * "bad-option" (options, or a context that cannot draw).
   */
  render(context: PathContext, options?: DualOptions): void;
  render(context?: null, options?: DualOptions): string;
  render(context?: PathContext | null, options?: DualOptions): string | void;

  /**
   * Draws the circles of all sites, hidden ones too (none for radii of 0 or less). O(n). Throws
   * "not-finite", "out-of-range", "bad-option" as `render`.
   */
  renderSites(context: PathContext, options?: DrawOptions): void;
  renderSites(context?: null, options?: DrawOptions): string;
  renderSites(context?: PathContext | null, options?: DrawOptions): string | void;

  /**
   * Draws the convex hull of the circles, arcs and tangents, as one closed figure. O(length), and
   * a look at all circles, whose box the default tolerance is a share of. Throws "not-finite",
   * "out-of-range", "bad-option" as `render`.
   */
  renderHull(context: PathContext, options?: DrawOptions): void;
  renderHull(context?: null, options?: DrawOptions): string;
  renderHull(context?: PathContext | null, options?: DrawOptions): string | void;

  /**
   * The smallest circle around all circles, and the ids of the sites that touch it from inside;
   * null if the diagram is empty. Which sites touch it is decided exactly. Its numbers are
   * rounded once, so the same sites give the same bits after any history. Cost: O(length of the
   * hull) for each of a few circles.
   */
  smallestEnclosingCircle(): EnclosingCircle | null;
}

/** The class of these diagrams. Its calls are those of `apollonius-diagram/core`. */
export interface DiagramClass
  extends Pick<typeof Core, "from" | "fromAsync" | "fromBytes" | "fromBytesAsync"> {
  /**
   * A diagram of flat x, y, r triples, or with the option `r` of x, y pairs; their ids are 0, 1, 2,
   * … in input order. Cost: expected O(n log n). Throws "not-finite", "out-of-range", "bad-length"
   * (no multiple of 3, or of 2), "too-large" (more than 2^29 sites), "bad-option".
   */
  new (xyr?: ArrayLike<number>, options?: RadiusOption): Diagram;
  /** The calls of all diagrams. */
  readonly prototype: Diagram;
  from<T extends Circular>(items: Items<T>, options?: RadiusOption): Diagram;
  from<T>(items: Items<T>, x: Accessor<T>, y: Accessor<T>, options?: RadiusOption): Diagram;
  from<T>(
    items: Items<T>,
    x: Accessor<T>,
    y: Accessor<T>,
    r: Accessor<T> | undefined,
    options?: RadiusOption,
  ): Diagram;
  from(xyr: ArrayLike<number>, options?: RadiusOption): Diagram;
  fromAsync<T extends Circular>(items: Items<T>, options?: BuildOptions): Promise<Diagram>;
  fromAsync<T>(
    items: Items<T>,
    x: Accessor<T>,
    y: Accessor<T>,
    options?: BuildOptions,
  ): Promise<Diagram>;
  fromAsync<T>(
    items: Items<T>,
    x: Accessor<T>,
    y: Accessor<T>,
    r: Accessor<T> | undefined,
    options?: BuildOptions,
  ): Promise<Diagram>;
  fromAsync(xyr: ArrayLike<number>, options?: BuildOptions): Promise<Diagram>;
  fromBytes(bytes: Uint8Array | ArrayBuffer, options?: SnapshotOptions): Diagram;
  fromBytesAsync(bytes: Uint8Array | ArrayBuffer, options?: AsyncSnapshotOptions): Promise<Diagram>;
}

const methods = {
  voronoi(window, options) {
    return voronoi(this, window, options) as Voronoi;
  },
  edges(options?: EdgeOptions) {
    return edges(this, options);
  },
  render(context?: PathContext | null, options?: DualOptions) {
    return render(this, context, options);
  },
  renderSites(context?: PathContext | null, options?: DrawOptions) {
    return renderSites(this, context, options);
  },
  renderHull(context?: PathContext | null, options?: DrawOptions) {
    return renderHull(this, context, options);
  },
  smallestEnclosingCircle() {
    return smallestEnclosingCircle(this);
  },
} as Pick<
  Diagram,
  "voronoi" | "edges" | "render" | "renderSites" | "renderHull" | "smallestEnclosingCircle"
> &
  ThisType<Core>;

/** Gives diagrams these methods; returns their class. */
function withMethods(): DiagramClass {
  // Not enumerable, as methods of a class are.
  for (const [name, value] of Object.entries(methods))
    Object.defineProperty(Core.prototype, name, { value, writable: true, configurable: true });
  return Core as unknown as DiagramClass;
}

// A value of this file's own, so that a bundler does not follow the name to the other file and
// leave out the call: the entries have no `sideEffects` (package.json), as who imports
// ApolloniusError from them is to get nothing else.
export const Diagram = withMethods();
