// From the package's drawings, in the diagram's units, to paths on the screen.
import type { Voronoi } from "apollonius-diagram";
import type { Bounds } from "../model/circle.js";
import type { Sites } from "../model/sites.js";
import type { Box, View } from "./view.js";

const kTolerance = 0.2; // pixels between a drawn curve and the true one,
const kLiveTolerance = 0.7; // and while all of them move
// pixels by which cells are drawn larger than the window, so that its border is not seen
const kMargin = 8;
const kMostInPath = 2000; // pieces in one path: very long paths are slow to stroke

/** The options for drawings at this scale. */
export const drawOptions = (view: View, isLive: boolean = false) => ({
  tolerance: (isLive ? kLiveTolerance : kTolerance) / view.scale,
});

/**
 * A box of the window, enlarged by some pixels, as bounds in the diagram's units; null where the
 * view is beyond what numbers resolve.
 */
export function boundsOf(view: View, box: Box, margin = 0) {
  const rounded = (x: number) => (Math.abs(x) < 1e-90 ? 0 : x);
  const bounds: Bounds = [
    rounded(view.toWorldX(box.left - margin)),
    rounded(view.toWorldY(box.bottom + margin)),
    rounded(view.toWorldX(box.right + margin)),
    rounded(view.toWorldY(box.top - margin)),
  ];
  return bounds[0] < bounds[2] && bounds[1] < bounds[3] ? bounds : null;
}

/** Draws onto the screen what is drawn in the diagram's units. */
class ScreenPath {
  constructor(
    readonly path: CanvasPath,
    readonly view: View,
  ) {}
  moveTo(x: number, y: number) {
    this.path.moveTo(this.view.toScreenX(x), this.view.toScreenY(y));
  }
  lineTo(x: number, y: number) {
    this.path.lineTo(this.view.toScreenX(x), this.view.toScreenY(y));
  }
  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number) {
    const { path, view } = this;
    path.bezierCurveTo(
      view.toScreenX(x1),
      view.toScreenY(y1),
      view.toScreenX(x2),
      view.toScreenY(y2),
      view.toScreenX(x),
      view.toScreenY(y),
    );
  }
  closePath() {
    this.path.closePath();
  }
}

/**
 * Strokes what is drawn in the diagram's units, in paths of bounded length, and leaves out what
 * does not meet the box.
 */
export class ScreenStrokes {
  #x = 0;
  #y = 0;
  #startX = 0;
  #startY = 0;
  #isUp = true; // the path is elsewhere
  #pieces = 0;

  /** @param box in pixels */
  constructor(
    readonly context: CanvasRenderingContext2D,
    readonly view: View,
    readonly box: Box,
  ) {
    context.beginPath();
  }

  moveTo(x: number, y: number) {
    this.#goTo(this.view.toScreenX(x), this.view.toScreenY(y));
    this.#startX = this.#x;
    this.#startY = this.#y;
    this.#isUp = true;
  }

  lineTo(x: number, y: number) {
    this.#lineTo(this.view.toScreenX(x), this.view.toScreenY(y));
  }

  #lineTo(sx: number, sy: number) {
    if (
      this.#meets(
        Math.min(this.#x, sx),
        Math.min(this.#y, sy),
        Math.max(this.#x, sx),
        Math.max(this.#y, sy),
      )
    )
      this.context.lineTo(sx, sy);
    this.#goTo(sx, sy);
  }

  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number) {
    const { view } = this;
    const [ax, ay, bx, by] = [
      view.toScreenX(x1),
      view.toScreenY(y1),
      view.toScreenX(x2),
      view.toScreenY(y2),
    ];
    const [sx, sy] = [view.toScreenX(x), view.toScreenY(y)];
    const meets = this.#meets(
      Math.min(this.#x, ax, bx, sx),
      Math.min(this.#y, ay, by, sy),
      Math.max(this.#x, ax, bx, sx),
      Math.max(this.#y, ay, by, sy),
    );
    if (meets) this.context.bezierCurveTo(ax, ay, bx, by, sx, sy);
    this.#goTo(sx, sy);
  }

  closePath() {
    this.#lineTo(this.#startX, this.#startY);
  }

  /** The last call: strokes what has not been stroked yet. */
  finish() {
    this.context.stroke();
  }

  #goTo(x: number, y: number) {
    this.#x = x;
    this.#y = y;
  }

  /** Whether a piece with these bounds is to be drawn; then the path is at its start. */
  #meets(left: number, top: number, right: number, bottom: number) {
    const { box, context } = this;
    if (right < box.left || left > box.right || bottom < box.top || top > box.bottom) {
      this.#isUp = true;
      return false;
    }
    if (++this.#pieces % kMostInPath === 0) {
      context.stroke();
      context.beginPath();
      this.#isUp = true;
    }
    if (this.#isUp) context.moveTo(this.#x, this.#y);
    this.#isUp = false;
    return true;
  }
}

/** All of it, in pixels. */
export const windowOf = (view: View) => ({
  left: 0,
  top: 0,
  right: view.width,
  bottom: view.height,
});

/**
 * Adds a site's cell as closed figures, correct inside the window; nothing for a hidden site. To be
 * filled or stroked.
 * @param ends the cells, if they end elsewhere
 */
export function addCell(
  path: CanvasPath,
  sites: Sites,
  view: View,
  id: number,
  ends: Voronoi | null = null,
) {
  const bounds = boundsOf(view, windowOf(view), kMargin);
  const cells = ends ?? (bounds && sites.diagram.voronoi(bounds));
  cells?.renderCell(id, new ScreenPath(path, view), drawOptions(view));
}

/**
 * The corners of the curves around a site's cell (ends and control points), inside and near the
 * window; null if there is no cell.
 */
export function cellCorners(sites: Sites, view: View, id: number) {
  const bounds = boundsOf(view, windowOf(view), kMargin);
  const cell = bounds && sites.diagram.voronoi(bounds).cellCurves(id);
  if (!cell) return null;
  const corners: [number, number][] = [];
  for (let k = 0; k < cell.curves.length; k += 7) {
    const [x0, y0, x1, y1, , x2, y2] = cell.curves.subarray(k, k + 7);
    corners.push([x0, y0], [x1, y1], [x2, y2]);
  }
  return corners;
}
