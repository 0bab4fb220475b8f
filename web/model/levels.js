// The levels of the hierarchy above the diagram itself (paper, section 4).

/**
 * The ids of the sites on each level, from level 1 on.
 * @param {import("./sites.js").Sites} sites @returns {number[][]}
 */
export function upperLevels({ ids, diagram }) {
  const counts = diagram.levels();
  /** @type {number[][]} */ const levels = [];
  for (let k = 0; k < ids.length; k++) {
    for (let level = 1; level < counts[ids[k]]; level++) {
      levels[level - 1] ??= [];
      levels[level - 1].push(ids[k]);
    }
  }
  return levels;
}
