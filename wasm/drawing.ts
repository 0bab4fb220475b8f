// Drawings of the library's, played into whatever can draw.
import type { MainModule } from "../build/wasm/apollonius.mjs";
import { type NativeDiagram, runningModule } from "./module.js";
import { type PathContext, play } from "./path.js";

/** What the library can draw. */
export type Drawing = keyof MainModule["Drawing"];

// Commands in one portion of a drawing: few enough to stay in the processor's cache.
const kPortion = 4096;

/** Draws portion by portion, between which the context may do anything: even change the diagram. */
export function drawInto(
  context: PathContext,
  native: NativeDiagram,
  what: Drawing,
  bounds: readonly [number, number, number, number],
  tolerance: number,
): void {
  const drawing = runningModule().Drawing[what];
  for (let cursor = 0, isDone = false; !isDone; ) {
    const portion = native.draw(drawing, ...bounds, tolerance, cursor, kPortion);
    play(context, portion.commands, portion.coordinates);
    ({ cursor, isDone } = portion);
  }
}
