// Treemaps: operations that the package and d3-voronoi-treemap have in common. The set's name says
// which tree, as flare-220 or tree-1000: Flare's classes by package, or random ones.
import { readFileSync } from "node:fs";
import path from "node:path";
import { hierarchy } from "d3-hierarchy";
import { sampled } from "./sampling.mjs";
import { sharesOf } from "./shares.mjs";

export const kWidth = 960;
export const kHeight = 600;

const flareFile = new URL("../../web/data/flare.json", import.meta.url);

/** Leaves of lognormal sizes in groups of 5 to 12, and those in groups, up to one. */
export function randomTree(leaves) {
  let level = Array.from(sharesOf(leaves, true), (size) => ({ size }));
  let state = 7;
  const random = () => {
    state = (state * 48271) % 2147483647;
    return state / 2147483647;
  };
  while (level.length > 1) {
    const groups = [];
    for (let k = 0; k < level.length; ) {
      const count = 5 + Math.floor(8 * random());
      groups.push({ children: level.slice(k, k + count) });
      k += count;
    }
    level = groups;
  }
  return level[0];
}

function dataOf(set) {
  const [family, leaves] = path.basename(set).split("-");
  return family === "flare" ? JSON.parse(readFileSync(flareFile, "utf8")) : randomTree(+leaves);
}

/**
 * `layouts` by the name of the operation; `areaOf(node)`. The answer has the largest deviation of a
 * leaf's area from its share of the whole, relative to that.
 */
export function treemapOperations(layouts, areaOf) {
  const timed = (layout) => (request) => {
    const data = dataOf(request.set);
    let root;
    const prepare = () => {
      root = hierarchy(data)
        .sum(({ size = 0 }) => size)
        .sort((a, b) => b.value - a.value);
    };
    const leaves = hierarchy(data).leaves().length;
    const answer = sampled(request, leaves, () => void layout(root), prepare);
    const perValue = (kWidth * kHeight) / root.value;
    const deviation = root
      .leaves()
      .reduce(
        (most, leaf) => Math.max(most, Math.abs(areaOf(leaf) / (perValue * leaf.value) - 1)),
        0,
      );
    return { ...answer, deviation };
  };
  return Object.fromEntries(Object.entries(layouts).map(([name, layout]) => [name, timed(layout)]));
}

/** Labels of all leaves of a new layout: a leaf remembers its own. */
export function labelsOfTreemap(layout) {
  return (request) => {
    const data = dataOf(request.set);
    let leaves = [];
    const prepare = () => {
      leaves = layout(hierarchy(data).sum(({ size = 0 }) => size)).leaves();
    };
    const label = () => leaves.forEach((leaf) => leaf.label());
    return sampled(request, hierarchy(data).leaves().length, label, prepare);
  };
}
