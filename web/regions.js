// Which part of the window a change can touch: a change of one site changes the diagram inside the site's old and new cells only.
import { newArc } from "./bisector.js";
import { setVoronoiArc } from "./curves.js";

/** @typedef {import("./view.js").Box} Box */

const kLine = 4; // pixels: half a line's width, a dot, anti-aliasing

const everything = (view) => ({ left: 0, top: 0, right: view.width, bottom: view.height });

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
 * The box of a site's circle and cell. With the dual graph, whose edges stay inside the cells they connect, the cells of the
 * neighbours too.
 * @param {import("./scene.js").Scene} scene
 * @param {import("./view.js").View} view
 * @param {boolean} neighbors
 * @returns {Box}
 */
export function regionOf(scene, view, id, neighbors) {
  const { x, y, r } = scene.site(id);
  const box = { left: Infinity, top: Infinity, right: -Infinity, bottom: -Infinity };
  addPoint(box, view, x, y, r);
  if (!scene.isVisible(id)) return box;
  if (!addCell(box, scene, view, id)) return everything(view);
  if (neighbors) {
    for (const other of scene.diagram.neighbors(id)) {
      const site = scene.site(other);
      addPoint(box, view, site.x, site.y, site.r);
      if (!addCell(box, scene, view, other)) return everything(view);
    }
  }
  return box;
}

/** False if the cell is unbounded. */
function addCell(box, scene, view, id) {
  const { edgeVertices } = scene.graph();
  const disc = view.disc();
  const arc = newArc();
  const rows = scene.edgesOf(id);
  for (const row of rows) {
    if (edgeVertices[2 * row] < 0 || edgeVertices[2 * row + 1] < 0) return false;
    if (!setVoronoiArc(scene, row, disc, arc)) continue;
    addPoint(box, view, arc.x0, arc.y0);
    addPoint(box, view, arc.x1, arc.y1);
    addPoint(box, view, arc.x2, arc.y2);
  }
  return rows.length > 0;
}
