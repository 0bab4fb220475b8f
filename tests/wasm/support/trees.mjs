// Trees for treemaps, and checks of what a treemap promises.
import { readFileSync } from "node:fs";
import { hierarchy } from "d3-hierarchy";
import { generator } from "./random.mjs";

const flareFile = new URL("../../../web/data/flare.json", import.meta.url);

/** The classes of the Flare toolkit by package: 220 leaves, four levels. */
export const flare = JSON.parse(readFileSync(flareFile, "utf8"));

/** d3-hierarchy's root of data with sizes, the largest children first. */
export const rootOf = (data) =>
  hierarchy(data)
    .sum(({ size = 0 }) => size)
    .sort((a, b) => b.value - a.value);

/** A tree of one level. */
export const flat = (sizes) => ({
  name: "all",
  children: Array.from(sizes, (size, k) => ({ name: `leaf ${k}`, size })),
});

/** Leaves of sizes that are lognormal, in groups of 2 to 9, and those in groups, up to one. */
export function randomTree(leaves, seed, sigma = 1) {
  const random = generator(seed);
  const normal = () => Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random());
  let level = Array.from({ length: leaves }, (_, k) => ({
    name: `leaf ${k}`,
    size: Math.exp(sigma * normal()),
  }));
  while (level.length > 1) {
    const groups = [];
    for (let k = 0; k < level.length; ) {
      const count = Math.min(2 + Math.floor(8 * random()), level.length);
      groups.push({ name: `group ${groups.length}`, children: level.slice(k, k + count) });
      k += count;
    }
    level = groups;
  }
  return level[0];
}

/** The signed area of a closed ring. */
export function areaOf(ring) {
  const [x0, y0] = ring[0];
  return ring.slice(1).reduce((sum, [x, y], k) => {
    const [fromX, fromY] = ring[k];
    return sum + ((fromX - x0) * (y - y0) - (x - x0) * (fromY - y0)) / 2;
  }, 0);
}

/** Is a point inside, by the even-odd rule? */
export function contains(ring, [x, y]) {
  let inside = false;
  for (let k = 0; k + 1 < ring.length; ++k) {
    const [[ax, ay], [bx, by]] = [ring[k], ring[k + 1]];
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) inside = !inside;
  }
  return inside;
}

/** The distance of a point from a ring. */
export function distanceTo(ring, [x, y]) {
  return ring.slice(1).reduce((least, [bx, by], k) => {
    const [ax, ay] = ring[k];
    const square = (bx - ax) ** 2 + (by - ay) ** 2;
    const t = square > 0 ? ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / square : 0;
    const near = Math.min(1, Math.max(0, t));
    return Math.min(least, Math.hypot(x - ax - near * (bx - ax), y - ay - near * (by - ay)));
  }, Infinity);
}

/** The largest deviation of a node's area from its share of the whole, relative to that. */
export function deviationOf(root) {
  let most = 0;
  root.each(({ area, value }) => {
    if (value > 0) most = Math.max(most, Math.abs(area / ((root.area * value) / root.value) - 1));
  });
  return most;
}

/** The largest deviation of a polygon's area from the node's. */
export function polygonDeviationOf(root) {
  let most = 0;
  root.each(({ area, polygon }) => {
    if (polygon !== null) most = Math.max(most, Math.abs(areaOf(polygon) / area - 1));
  });
  return most;
}
