// Where the nearest centre is not the nearest circle's: the window is asked at a grid of places,
// in the diagram of the centres and in that of the circles.
import type { Box, View } from "../picture/view.js";
import type { Sites } from "./sites.js";

/** A place in pixels. */
type Place = { x: number; y: number };
/** `share` of the window, from 0 to 1; a place with a wrong pick, and a right one near it. */
export type Verdict = { share: number; wrong: Place | null; right: Place | null };

const kStep = 8; // pixels between places
const kApart = 40; // pixels, at least, from a wrong place to the right one
const kRounding = 1e-12; // of a distance, which is rounded: ties are not wrong

/** @param free what no bar covers: both places are in there */
export function verdictOf(sites: Sites, view: View, free: Box): Verdict | null {
  const truth = sites.truth;
  if (!truth || sites.size === 0) return null;
  const columns = Math.max(1, Math.floor(view.width / kStep));
  const count = columns * Math.max(1, Math.floor(view.height / kStep));
  const placeOf = (k: number) => ({
    x: ((k % columns) + 0.5) * kStep,
    y: (Math.floor(k / columns) + 0.5) * kStep,
  });
  const xy = new Float64Array(2 * count);
  for (let k = 0; k < count; k++) {
    const { x, y } = placeOf(k);
    xy[2 * k] = view.toWorldX(x);
    xy[2 * k + 1] = view.toWorldY(y);
  }
  const toCentre = new Float64Array(count);
  const toCircle = new Float64Array(count);
  const picked = sites.diagram.findMany(xy, toCentre);
  const nearest = truth.diagram.findMany(xy, toCircle);
  const excess = (k: number) => toCentre[k] - sites.site(picked[k]).r - toCircle[k];
  const isWrong = (k: number) =>
    picked[k] !== truth.ids[nearest[k]] && excess(k) > kRounding * toCentre[k];
  const isFree = (k: number) => {
    const { x, y } = placeOf(k);
    return x > free.left && x < free.right && y > free.top && y < free.bottom;
  };

  const wrongs: number[] = [];
  for (let k = 0; k < count; k++) if (isWrong(k)) wrongs.push(k);
  const worst = bestOf(wrongs.filter(isFree), excess);
  if (worst < 0) return { share: wrongs.length / count, wrong: null, right: null };
  const wrong = placeOf(worst);
  const rights = Array.from({ length: count }, (_, k) => k).filter(
    (k) => isFree(k) && picked[k] === truth.ids[nearest[k]] && nearest[k] === nearest[worst],
  );
  const right = bestOf(rights, (k) => {
    const { x, y } = placeOf(k);
    const distance = Math.hypot(x - wrong.x, y - wrong.y);
    return distance < kApart ? -Infinity : -distance;
  });
  return { share: wrongs.length / count, wrong, right: right < 0 ? null : placeOf(right) };
}

/** The one with the largest value, or -1. */
function bestOf(candidates: readonly number[], worth: (k: number) => number) {
  let best = -1;
  let most = -Infinity;
  for (const k of candidates) {
    const value = worth(k);
    if (value <= most) continue;
    most = value;
    best = k;
  }
  return best;
}
