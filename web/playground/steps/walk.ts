// The search for the nearest site (paper, section 4): from site to neighbour as long as one is
// nearer; and the same on each level of the hierarchy, from where it ended on the one above.
import { Diagram } from "apollonius-diagram";
import { upperLevels } from "../model/levels.js";
import type { Sites } from "../model/sites.js";

/** The sites of a level, and those that the walk meets there. */
export type Stage = { level: number; ids: ArrayLike<number>; path: number[] };

/** The sites that a walk meets. */
export function walk(diagram: Diagram, { x, y }: { x: number; y: number }, start: number) {
  const distance = (id: number) => {
    const site = diagram.site(id);
    return Math.hypot(site.x - x, site.y - y) - site.r;
  };
  const path = [start];
  for (let at = start; ; ) {
    const nearer = [...diagram.neighbors(at)].filter((id) => distance(id) < distance(at));
    if (nearer.length === 0) return path;
    at = nearer.reduce((a, b) => (distance(b) < distance(a) ? b : a));
    path.push(at);
  }
}

/**
 * The walks from the top level down to the diagram itself; none if there is no level with two
 * sites.
 */
export function descent(sites: Sites, point: { x: number; y: number }): Stage[] {
  const levels = upperLevels(sites).filter((ids) => ids.length > 1);
  const stages: Stage[] = [];
  let start = -1;
  for (let level = levels.length; level > 0; level--) {
    const ids = levels[level - 1];
    const diagram = new Diagram(sites.countingTriples(ids));
    const from = Math.max(0, ids.indexOf(start)); // on the top level anywhere
    const path = walk(diagram, point, from).map((row) => ids[row]);
    diagram.dispose();
    stages.push({ level, ids, path });
    start = path[path.length - 1];
  }
  if (stages.length > 0)
    stages.push({ level: 0, ids: sites.ids, path: walk(sites.diagram, point, start) });
  return stages;
}
