// The smallest circle around circles that are in no diagram.
import type { Circular, Items } from "../core/accessors.js";
import { Diagram } from "../core/diagram.js";
import { smallestEnclosingCircle } from "./functions.js";
import type { EnclosingCircle } from "./types.js";

/**
 * The smallest circle around circles, in place of d3-hierarchy's `packEnclose`; undefined if
 * `circles` is empty. It reads objects or arrays as `Diagram.from` does. `sites` has the indices of
 * the circles that touch the result from inside. Cost: O(n log n). Throws as `Diagram.from`.
 */
export function enclose<T extends Circular>(circles: Items<T>): EnclosingCircle | undefined {
  const diagram = Diagram.from(circles);
  try {
    return smallestEnclosingCircle(diagram) ?? undefined;
  } finally {
    diagram.dispose();
  }
}
