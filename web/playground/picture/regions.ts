// Which part of the window a change can touch: a change of one site changes the diagram inside the
// site's old and new cells only.
import type { Sites } from "../model/sites.js";
import { cellCorners } from "./curves.js";
import type { Box, View } from "./view.js";

const kLine = 4; // pixels: half a line's width, a dot, anti-aliasing

function addPoint(box: Box, view: View, x: number, y: number, r = 0) {
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
 */
export function regionOf(sites: Sites, view: View, id: number, neighbors: boolean): Box {
  const { x, y, r } = sites.site(id);
  const box = { left: Infinity, top: Infinity, right: -Infinity, bottom: -Infinity };
  addPoint(box, view, x, y, r);
  addCell(box, sites, view, id);
  if (neighbors) {
    for (const other of sites.diagram.neighbors(id)) {
      const site = sites.site(other);
      addPoint(box, view, site.x, site.y, site.r);
      addCell(box, sites, view, other);
    }
  }
  return box;
}

function addCell(box: Box, sites: Sites, view: View, id: number) {
  for (const [x, y] of cellCorners(sites, view, id) ?? []) addPoint(box, view, x, y);
}
