// Lloyd's relaxation: every circle goes towards the centroid of its cell, which makes cells round
// and of like size. Hidden circles have no cell and stay.
import type { Sites } from "../model/sites.js";
import type { Step } from "./motion.js";

const kPerSecond = 3; // the share of its way that a circle goes in a second, at first

export function relax(sites: Sites): Step {
  const { ids, diagram } = sites;
  const xyr = sites.triples(ids);
  const bounds = sites.bounds();
  if (!bounds) return () => xyr;
  const window = diagram.voronoi(bounds);
  return (seconds: number) => {
    const share = 1 - Math.exp(-kPerSecond * seconds);
    for (let k = 0; k < ids.length; k++) {
      const centroid = sites.isHidden(ids[k]) ? null : window.cellCentroid(ids[k]);
      if (!centroid) continue;
      xyr[3 * k] += (centroid[0] - xyr[3 * k]) * share;
      xyr[3 * k + 1] += (centroid[1] - xyr[3 * k + 1]) * share;
    }
    return xyr;
  };
}
