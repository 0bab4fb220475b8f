// The neighbours of a site that one sees: those whose cells have an edge in common with its own.
// The dual graph can have more: where four or more cells meet in one vertex, some of its edges
// belong to Voronoi edges without a length.
import type { Sites } from "./sites.js";

const kFar = 1e7; // a window for whole cells: this many times the coordinates
const kRounding = 1e-11; // of the coordinates: an edge this short is a point, as they are rounded

/** Ids, in the order around the cell. */
export function neighborsOf(sites: Sites, id: number): Uint32Array {
  const { x, y, r } = sites.site(id);
  const reach = kFar * Math.max(Math.abs(x), Math.abs(y), Math.abs(r), 1);
  const cell = sites.diagram.voronoi([-reach, -reach, reach, reach]).cellCurves(id);
  const found = new Set<number>();
  for (let k = 0; cell && k < cell.neighbors.length; k++) {
    if (cell.neighbors[k] < 0) continue; // along the window's border
    const [x0, y0, , , , x2, y2] = cell.curves.subarray(7 * k, 7 * k + 7);
    const size = Math.max(...[x0, y0, x2, y2, x, y, r].map(Math.abs));
    if (Math.hypot(x2 - x0, y2 - y0) > kRounding * size) found.add(cell.neighbors[k]);
  }
  return Uint32Array.from(found);
}
