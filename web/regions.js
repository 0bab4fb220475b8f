// Which part of the window a change can touch: a change of one site changes the diagram inside the
// site's old and new cells only.
import { cellCorners } from "./curves.js";

/** @typedef {import("./view.js").Box} Box */

const kLine = 4; // pixels: half a line's width, a dot, anti-aliasing

/** @param {Box} box */
function addPoint(box, view, x, y, r = 0) {
  const sx = view.toScreenX(x);
  const sy = view.toScreenY(y);
  const pad = Math.max(r, 0) * view.scale + kLine;
  box.left = Math.min(box.left, sx - pad);
  box.top = Math.min(box.top, sy - pad);
  box.right = Math.max(box.right, sx + pad);
  box.bottom = Math.max(box.bottom, sy + pad);
}

/**
 * The box of a site's circle and cell. With the dual graph, whose edges stay inside the cells they
 * connect, the cells of the neighbours too.
 * @param {import("./scene.js").Scene} scene
 * @param {import("./view.js").View} view
 * @param {boolean} neighbors
 * @returns {Box}
 */
export function regionOf(scene, view, id, neighbors) {
  const { x, y, r } = scene.site(id);
  const box = { left: Infinity, top: Infinity, right: -Infinity, bottom: -Infinity };
  addPoint(box, view, x, y, r);
  addCell(box, scene, view, id);
  if (neighbors) {
    for (const other of scene.diagram.neighbors(id)) {
      const site = scene.site(other);
      addPoint(box, view, site.x, site.y, site.r);
      addCell(box, scene, view, other);
    }
  }
  return box;
}

function addCell(box, scene, view, id) {
  for (const [x, y] of cellCorners(scene, view, id) ?? []) addPoint(box, view, x, y);
}
