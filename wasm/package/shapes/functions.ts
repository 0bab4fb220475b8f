// Windows, drawings and the enclosing circle of a diagram as functions of it: for diagrams of the
// entry `apollonius-diagram/core`, which has no such methods.
import type { Diagram } from "../core/diagram.js";
import { nativeOf } from "../core/inner.js";
import { type NativeShapes, runningModule, shapesOf } from "../core/native/module.js";
import type { DrawOptions, PathContext } from "../core/path.js";
import type { Edges } from "../core/types.js";
import { drawDual, drawWhole } from "./drawing.js";
import { isWithClearance, narrowestOf } from "./edges.js";
import type { WindowShape } from "./region.js";
import type {
  CellCircle,
  DualOptions,
  EdgeOptions,
  EdgesWithClearance,
  EnclosingCircle,
  VoronoiOptions,
} from "./types.js";
import { Voronoi } from "./voronoi.js";

/**
 * The cells of a diagram inside a window: `diagram.voronoi(window, options)` of the default entry,
 * with its defaults, cost and errors.
 */
export function voronoi(
  diagram: Diagram,
  window: WindowShape = [0, 0, 960, 500],
  options?: VoronoiOptions,
): Voronoi {
  return Voronoi.of(diagram, window, options);
}

/** All Voronoi edges: `diagram.edges(options)` of the default entry. */
export function edges(
  diagram: Diagram,
  options: EdgeOptions & { clearance: true },
): EdgesWithClearance;
export function edges(diagram: Diagram, options?: EdgeOptions): Edges;
export function edges(diagram: Diagram, options?: EdgeOptions): Edges {
  const isClear = isWithClearance(options);
  const native = nativeOf(diagram);
  return isClear
    ? { ...native.edges(), ...narrowestOf(shapesOf(native).narrowest()) }
    : native.edges();
}

/** Draws the dual graph: `diagram.render(context, options)` of the default entry. */
export function render(diagram: Diagram, context: PathContext, options?: DualOptions): void;
export function render(diagram: Diagram, context?: null, options?: DualOptions): string;
export function render(
  diagram: Diagram,
  context?: PathContext | null,
  options?: DualOptions,
): string | void;
export function render(
  diagram: Diagram,
  context?: PathContext | null,
  options?: DualOptions,
): string | void {
  return drawDual(shapesOf(nativeOf(diagram)), context, options);
}

/** Draws the circles of all sites: `diagram.renderSites(context, options)` of the default entry. */
export function renderSites(diagram: Diagram, context: PathContext, options?: DrawOptions): void;
export function renderSites(diagram: Diagram, context?: null, options?: DrawOptions): string;
export function renderSites(
  diagram: Diagram,
  context?: PathContext | null,
  options?: DrawOptions,
): string | void;
export function renderSites(
  diagram: Diagram,
  context?: PathContext | null,
  options?: DrawOptions,
): string | void {
  return drawWhole(shapesOf(nativeOf(diagram)), "sites", undefined, context, options);
}

/** Draws the convex hull: `diagram.renderHull(context, options)` of the default entry. */
export function renderHull(diagram: Diagram, context: PathContext, options?: DrawOptions): void;
export function renderHull(diagram: Diagram, context?: null, options?: DrawOptions): string;
export function renderHull(
  diagram: Diagram,
  context?: PathContext | null,
  options?: DrawOptions,
): string | void;
export function renderHull(
  diagram: Diagram,
  context?: PathContext | null,
  options?: DrawOptions,
): string | void {
  return drawWhole(shapesOf(nativeOf(diagram)), "hull", undefined, context, options);
}

/**
 * The smallest circle around all circles: `diagram.smallestEnclosingCircle()` of the default entry.
 */
export function smallestEnclosingCircle(diagram: Diagram): EnclosingCircle | null {
  const { x, y, r, sites } = shapesOf(nativeOf(diagram)).enclosingCircle();
  return sites.length === 0 ? null : { x, y, r, sites };
}

/** An empty diagram, through which the running module is asked about what is in none. */
let host: { module: ReturnType<typeof runningModule>; native: NativeShapes } | undefined;

/** @internal The largest circle inside an outline, as `cellCircle` finds it in a cell. */
export function innerCircle(
  { curves, starts }: { readonly curves: Float64Array; readonly starts: Uint32Array },
  aspect: number,
): CellCircle {
  const module = runningModule();
  if (host?.module !== module) host = { module, native: shapesOf(module.create()) };
  return host.native.innerCircle(curves, starts, aspect);
}
