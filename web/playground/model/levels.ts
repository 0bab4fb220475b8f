// The levels of the hierarchy above the diagram itself (paper, section 4).
import type { Sites } from "./sites.js";

/** The ids of the sites on each level, from level 1 on. */
export function upperLevels({ ids, diagram }: Sites): number[][] {
  const counts = diagram.levels();
  const levels: number[][] = [];
  for (let k = 0; k < ids.length; k++) {
    for (let level = 1; level < counts[ids[k]]; level++) {
      levels[level - 1] ??= [];
      levels[level - 1].push(ids[k]);
    }
  }
  return levels;
}
