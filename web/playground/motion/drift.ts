// Every circle goes its way at a constant speed, and turns at the border.
import type { Sites } from "../model/sites.js";
import { generator } from "../../shared/random_sets.js";
import type { Step } from "./motion.js";

const kCrossing = 40; // seconds that the fastest one takes from border to border

export function drift(sites: Sites): Step {
  const { ids } = sites;
  const xyr = sites.triples(ids);
  const bounds = sites.bounds();
  if (!bounds) return () => xyr;
  const [xmin, ymin, xmax, ymax] = bounds;
  const random = generator(1);
  const fastest = Math.hypot(xmax - xmin, ymax - ymin) / kCrossing;
  const speed = Float64Array.from({ length: 2 * ids.length }, () => fastest * (2 * random() - 1));
  /** One coordinate of all of them: the axis'th. */
  const go = (axis: number, low: number, high: number, seconds: number) => {
    for (let k = axis, n = axis; k < xyr.length; k += 3, n += 2) {
      const next = xyr[k] + speed[n] * seconds;
      if (next < low || next > high) speed[n] *= -1;
      else xyr[k] = next;
    }
  };
  return (seconds: number) => {
    go(0, xmin, xmax, seconds);
    go(1, ymin, ymax, seconds);
    return xyr;
  };
}
