// Windows, drawings and the enclosing circle as methods of Diagram: what the default entry adds to
// that of `apollonius-diagram/core`, which is the same class.
import { Diagram as Core } from "../core/diagram.js";
import type { DrawOptions, PathContext } from "../core/path.js";
import type { Edges } from "../core/types.js";
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
import type { Voronoi } from "./voronoi.js";

declare module "../core/diagram.js" {
  interface Diagram {
    // --- Cells and drawings ----------------------------------------------------------------------

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
     * Draws the convex hull of the circles, arcs and tangents, as one closed figure. O(length).
     * Throws "not-finite", "out-of-range", "bad-option" as `render`.
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
}

const methods = {
  voronoi(window, options) {
    return voronoi(this, window, options);
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
  Core,
  "voronoi" | "edges" | "render" | "renderSites" | "renderHull" | "smallestEnclosingCircle"
> &
  ThisType<Core>;

/** Gives diagrams these methods; returns their class. */
function withMethods(): typeof Core {
  // Not enumerable, as methods of a class are.
  for (const [name, value] of Object.entries(methods))
    Object.defineProperty(Core.prototype, name, { value, writable: true, configurable: true });
  return Core;
}

// A value of this file's own, so that a bundler does not follow the name to the other file and
// leave out the call: the entries have no `sideEffects` (package.json), as who imports
// ApolloniusError from them is to get nothing else.
export const Diagram = withMethods();
export type Diagram = Core;
