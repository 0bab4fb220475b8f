// Where the nearest centre is not the nearest circle's: the window is asked at a grid of places,
// in the diagram of the centres and in that of the circles.
import type { View } from "./view.js";
import type { Sites } from "../model/sites.js";

const kStep = 8; // pixels between places
const kRounding = 1e-12; // of a distance, which is rounded: ties are not wrong

/** The share of the window that has a wrong pick, from 0 to 1; null if that is not known. */
export function wrongShare(sites: Sites, view: View) {
  const truth = sites.truth;
  if (!truth || sites.size === 0) return null;
  const columns = Math.max(1, Math.floor(view.width / kStep));
  const count = columns * Math.max(1, Math.floor(view.height / kStep));
  const xy = new Float64Array(2 * count);
  for (let k = 0; k < count; k++) {
    xy[2 * k] = view.toWorldX(((k % columns) + 0.5) * kStep);
    xy[2 * k + 1] = view.toWorldY((Math.floor(k / columns) + 0.5) * kStep);
  }
  const { ids: picked, distances: toCentre } = sites.diagram.nearestMany(xy);
  const { ids: nearest, distances: toCircle } = truth.diagram.nearestMany(xy);
  let wrong = 0;
  for (let k = 0; k < count; k++) {
    const excess = toCentre[k] - sites.site(picked[k]).r - toCircle[k];
    if (picked[k] !== truth.ids[nearest[k]] && excess > kRounding * toCentre[k]) wrong++;
  }
  return wrong / count;
}
