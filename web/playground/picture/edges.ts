// The edges of the cells that meet a window, and no others: cells that have a part in a window are
// connected there, so they are found from one of them, neighbour by neighbour. What that costs
// depends on the window, not on the size of the diagram; and it can be done in slices. With the
// package's drawings it cannot: `render` passes over the whole diagram, `renderCell` draws an edge
// twice. So conics, which the package gives as they are (`cellCurves`), become cubics here.
import type { Diagram, PathContext } from "apollonius-diagram";
import type { Bounds } from "../model/circle.js";

const kStraight = 1e-9; // weights below are segments
const kFlat = 1.06; // a conic of at most this weight is as good as the cubic with its tangents
const kDeepest = 12; // halvings

export type EdgeTarget = Pick<PathContext, "moveTo" | "lineTo" | "bezierCurveTo">;

/**
 * Draws each edge once, yielding after each cell.
 * @param bounds of the window
 * @param target in the diagram's units
 */
export function* drawEdges(diagram: Diagram, bounds: Bounds, target: EdgeTarget) {
  const [xmin, ymin, xmax, ymax] = bounds;
  const first = diagram.find((xmin + xmax) / 2, (ymin + ymax) / 2);
  if (first < 0) return;
  const window = diagram.voronoi(bounds);
  const seen = new Set([first]);
  for (const id of seen) {
    const cell = window.cellCurves(id);
    if (!cell) continue;
    const { curves, neighbors } = cell;
    for (let k = 0; k < neighbors.length; k++) {
      const other = neighbors[k];
      if (other < 0) continue; // along the window's border
      seen.add(other); // what is added on the way is met later
      if (other > id) addConic(target, curves, 7 * k);
    }
    yield;
  }
}

/** The conic x0, y0, x1, y1, w, x2, y2 at `at`, as a segment or as cubics. */
function addConic(target: EdgeTarget, curves: Float64Array, at: number) {
  const [x0, y0, x1, y1, w, x2, y2] = curves.subarray(at, at + 7);
  target.moveTo(x0, y0);
  if (w < kStraight) target.lineTo(x2, y2);
  else addPiece(target, x0, y0, x1, y1, w, x2, y2, kDeepest);
}

function addPiece(
  target: EdgeTarget,
  x0: number,
  y0: number,
  x1: number,
  y1: number,
  w: number,
  x2: number,
  y2: number,
  depth: number,
) {
  if (w <= kFlat || depth === 0) {
    const f = (4 * w) / (3 * (1 + w));
    target.bezierCurveTo(
      x0 + f * (x1 - x0),
      y0 + f * (y1 - y0),
      x2 + f * (x1 - x2),
      y2 + f * (y1 - y2),
      x2,
      y2,
    );
    return;
  }
  // At its shoulder a conic falls into two alike.
  const ax = (x0 + w * x1) / (1 + w);
  const ay = (y0 + w * y1) / (1 + w);
  const bx = (x2 + w * x1) / (1 + w);
  const by = (y2 + w * y1) / (1 + w);
  const half = Math.sqrt((1 + w) / 2);
  addPiece(target, x0, y0, ax, ay, half, (ax + bx) / 2, (ay + by) / 2, depth - 1);
  addPiece(target, (ax + bx) / 2, (ay + by) / 2, bx, by, half, x2, y2, depth - 1);
}
