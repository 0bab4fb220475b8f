// Every circle goes its way at a constant speed, and turns at the border.
import { generator } from "../sets/random_sets.js";

const kCrossing = 40; // seconds that the fastest one takes from border to border

/**
 * @param {import("../model/sites.js").Sites} sites
 * @returns {import("./motion.js").Step}
 */
export function drift(sites) {
  const { ids } = sites;
  const xyr = sites.triples(ids);
  const [xmin, ymin, xmax, ymax] = sites.bounds();
  const random = generator(1);
  const fastest = Math.hypot(xmax - xmin, ymax - ymin) / kCrossing;
  const speed = Float64Array.from({ length: 2 * ids.length }, () => fastest * (2 * random() - 1));
  return (seconds) => {
    for (let k = 0; k < ids.length; k++) {
      for (const [axis, low, high] of [
        [0, xmin, xmax],
        [1, ymin, ymax],
      ]) {
        const next = xyr[3 * k + axis] + speed[2 * k + axis] * seconds;
        if (next < low || next > high) speed[2 * k + axis] *= -1;
        else xyr[3 * k + axis] = next;
      }
    }
    return xyr.slice();
  };
}
