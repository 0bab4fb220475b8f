// Plays the library's drawings into any context.
import type { MainModule } from "../../../build/wasm/apollonius.mjs";
import { checkedBounds, checkedTolerance, checkOptions } from "../core/arguments.js";
import type { NativeReach, NativeRegion, NativeShapes } from "../core/native/module.js";
import { drawn, type DrawOptions, type PathContext, play } from "../core/path.js";
import type { Bounds } from "../core/types.js";
import type { DualOptions } from "./types.js";

/** The drawings that the library can make. */
export type Drawing = keyof MainModule["Drawing"];

/** A region or null, a reach of cells or null, and bounds, which count if there is no region. */
export type NativeWindow = readonly [
  NativeRegion | null,
  NativeReach | null,
  number,
  number,
  number,
  number,
];

// Commands in one portion of a drawing: few enough to stay in the processor's cache.
const kPortion = 4096;

/** Returns the tolerance as the library takes it: 0 means the default. */
export function toleranceOf(options: { tolerance?: number | undefined } | undefined): number {
  return checkedTolerance(options?.tolerance, () => 0);
}

/**
 * Draws portion by portion. While a portion is played, the context may even change the diagram, or
 * dispose of the view; `windowNow` then throws.
 */
export function drawInto(
  context: PathContext,
  native: NativeShapes,
  what: Drawing,
  windowNow: () => NativeWindow,
  tolerance: number,
): void {
  const drawing = native.Drawing[what];
  for (let cursor = 0, isDone = false; !isDone; ) {
    const portion = native.draw(...windowNow(), drawing, tolerance, cursor, kPortion);
    play(context, portion.commands, portion.coordinates);
    ({ cursor, isDone } = portion);
  }
}

/** Draws the border of a window. */
export function drawBounds(
  target: PathContext,
  native: NativeShapes,
  [region, , xmin, ymin, xmax, ymax]: NativeWindow,
): void {
  if (region !== null) {
    const { commands, coordinates } = native.drawRegion(region);
    play(target, commands, coordinates);
    return;
  }
  target.moveTo(xmin, ymin);
  target.lineTo(xmax, ymin);
  target.lineTo(xmax, ymax);
  target.lineTo(xmin, ymax);
  target.closePath();
}

/** Draws a whole diagram. Without bounds, the box of all circles gives the default tolerance. */
export function drawWhole(
  native: NativeShapes,
  what: Drawing,
  bounds: Bounds | undefined,
  context: PathContext | null | undefined,
  options: DrawOptions | undefined,
): string | void {
  const window = bounds ?? extentOf(native);
  const tolerance = toleranceOf(options);
  return drawn(context, options, (target) =>
    drawInto(target, native, what, () => [null, null, ...window], tolerance),
  );
}

/** Draws the dual graph of a whole diagram. */
export function drawDual(
  native: NativeShapes,
  context: PathContext | null | undefined,
  options: DualOptions | undefined,
): string | void {
  checkOptions(options, "tolerance", "digits", "bounds");
  const { bounds: given, tolerance, digits } = options ?? {};
  const bounds = given === undefined ? undefined : checkedBounds(given);
  const drawing = { tolerance, digits };
  return drawWhole(native, bounds ? "dualWithRays" : "dual", bounds, context, drawing);
}

/** Returns the box of all circles. */
function extentOf(native: NativeShapes): Bounds {
  const { xmin, ymin, xmax, ymax } = native.extent();
  return [xmin, ymin, xmax, ymax];
}
