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
  /** One coordinate of all of them: the axis'th. */
  const go = (axis, low, high, seconds) => {
    for (let k = axis, n = axis; k < xyr.length; k += 3, n += 2) {
      const next = xyr[k] + speed[n] * seconds;
      if (next < low || next > high) speed[n] *= -1;
      else xyr[k] = next;
    }
  };
  return (seconds) => {
    go(0, xmin, xmax, seconds);
    go(1, ymin, ymax, seconds);
    return xyr;
  };
}
