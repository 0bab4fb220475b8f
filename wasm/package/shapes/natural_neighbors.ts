// Natural neighbours: what a new site would take from the cells of others. Inside the new cell only
// those sites matter from which it takes something. So a diagram of these alone, with the new site
// and without it, says what is taken from each.
import type { Conflict } from "../../../build/wasm/apollonius.mjs";
import { type NativeDiagram, type NativeShapes, shapesOf } from "../core/native/module.js";
import { checkTypes, ofNumbers } from "../core/native/native_errors.js";
import type { NativeWindow } from "./drawing.js";
import type { NaturalWeights } from "./types.js";

const kOfCurve = 7; // numbers: from, control point, weight, to

/** null without sites, or if the new cell is outside of the window. */
export function naturalWeights(
  native: NativeShapes,
  window: NativeWindow,
  x: number,
  y: number,
  r: number,
): NaturalWeights | null {
  const { sites: ids, isCovered } = conflictWith(native, x, y, r);
  if (ids.length === 0) return null;
  if (isCovered) return { ids, weights: Float64Array.of(1) };
  const xyr = new Float64Array(3 * ids.length);
  ids.forEach((id, k) => {
    const site = native.site(id);
    xyr.set([site.x, site.y, site.r], 3 * k);
  });
  const local = shapesOf(native.emptyBeside() as NativeDiagram);
  try {
    local.insertMany(xyr, new Uint32Array(ids.length));
    const own = local.insert(x, y, r);
    const around = boxAround(local, own, window);
    if (around === null) return null;
    const after = local.cellAreas(...around);
    local.remove(own);
    const before = local.cellAreas(...around);
    const weights = Float64Array.from(ids, (_, k) => Math.max(0, before[k]! - after[k]!));
    const sum = weights.reduce((total, taken) => total + taken, 0);
    return sum > 0 ? { ids, weights: weights.map((taken) => taken / sum) } : null;
  } finally {
    local.delete();
  }
}

function conflictWith(native: NativeShapes, x: number, y: number, r: number): Conflict {
  checkTypes(x, y, r);
  try {
    return native.conflict(x, y, r);
  } catch (error) {
    throw ofNumbers(error, x, y, r);
  }
}

/** The window, or of a rectangle what is around the cell: there rounding loses little. */
function boxAround(local: NativeShapes, own: number, window: NativeWindow): NativeWindow | null {
  const [region, , ...bounds] = window;
  if (region !== null) return [region, null, ...bounds];
  const { curves } = local.cellCurves(null, null, ...bounds, own);
  if (curves.length === 0) return null;
  const box: [number, number, number, number] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let k = 0; k < curves.length; k += kOfCurve)
    for (const at of [k, k + 2, k + 5])
      for (const axis of [0, 1]) {
        const value = curves[at + axis]!;
        box[axis] = Math.min(box[axis]!, value);
        box[axis + 2] = Math.max(box[axis + 2]!, value);
      }
  const [xmin, ymin, xmax, ymax] = box;
  return xmin < xmax && ymin < ymax ? [null, null, ...box] : null;
}
