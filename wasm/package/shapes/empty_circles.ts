// Empty circles with their centres in a window: the places that are farthest from all sites.
//
// Along an edge, and along a straight side of the window inside one cell, the distance to the
// nearest site is convex, so it is largest at an end. Hence the candidates are Voronoi vertices in
// the window, the points where edges cross its border, and its corners. All but the corners are the
// ends of the edges as the window clips them.
import type { NativeShapes } from "../core/native/module.js";
import type { NativeWindow } from "./drawing.js";
import type { EmptyCircle } from "./types.js";

const kOfCurve = 7; // numbers: from, control point, weight, to

/** The `most` largest ones, none of which has its centre in one before it. */
export function emptyCircles(
  native: NativeShapes,
  window: NativeWindow,
  most: number,
): EmptyCircle[] {
  if (native.size() === 0) return [];
  const [region, , ...bounds] = window;
  const { curves } = native.edgeCurves(region, null, ...bounds); // whatever cells reach
  const places = cornersOf(native, window);
  const xy = new Float64Array(places.length + (4 * curves.length) / kOfCurve);
  xy.set(places);
  for (let from = 0, to = places.length; from < curves.length; from += kOfCurve, to += 4) {
    xy.set(curves.subarray(from, from + 2), to);
    xy.set(curves.subarray(from + 5, from + 7), to + 2);
  }
  const candidates: EmptyCircle[] = [];
  for (let k = 0; k < xy.length; k += 2) {
    const x = xy[k]!;
    const y = xy[k + 1]!;
    const { id, distance } = native.nearest(x, y);
    candidates.push({ x, y, r: distance, site: id });
  }
  candidates.sort((a, b) => b.r - a.r || a.x - b.x || a.y - b.y);
  return apart(candidates, most, (a, b) => Math.hypot(a.x - b.x, a.y - b.y));
}

/** The first `most` circles, none of which has its centre in one before it, or where that has. */
export function apart<Circle extends { r: number }>(
  circles: Iterable<Circle>,
  most: number,
  distance: (a: Circle, b: Circle) => number,
): Circle[] {
  const chosen: Circle[] = [];
  for (const circle of circles) {
    if (chosen.length >= most) break;
    const isApart = (one: Circle) => {
      const away = distance(one, circle);
      return !(away < one.r || away === 0);
    };
    if (chosen.every(isApart)) chosen.push(circle);
  }
  return chosen;
}

/** x, y, x, y, … */
function cornersOf(
  native: NativeShapes,
  [region, , xmin, ymin, xmax, ymax]: NativeWindow,
): Float64Array {
  return region === null
    ? Float64Array.of(xmin, ymin, xmax, ymin, xmax, ymax, xmin, ymax)
    : native.drawRegion(region).coordinates;
}
