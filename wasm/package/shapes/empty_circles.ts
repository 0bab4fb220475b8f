// Empty circles with their centres in a window: the places that are farthest from all sites.
//
// Along an edge, and along a straight side of the window inside one cell, the distance to the
// nearest site is convex, so it is largest at an end. Hence the candidates are Voronoi vertices in
// the window, the points where edges cross its border, and its corners. All but the corners are the
// ends of the edges as the window clips them.
//
// Circles inside the window must not reach beyond its border either. A candidate that does not is
// one of these circles. In the cells around the others the largest circle may touch the border:
// it is looked for (widest_place.ts), cell by cell, those with the farthest candidates first, and
// only until enough circles are found.
import type { NativeShapes } from "../core/native/module.js";
import { kOfCurve, length } from "./curves.js";
import { drawBounds, type NativeWindow, pathOfSides } from "./drawing.js";
import { boxOf } from "./inner_circle.js";
import type { EmptyCircle } from "./types.js";
import { type NearestCircle, nearestOf, Obstacles, widestPlace } from "./widest_place.js";

/**
 * The `most` largest ones, none of which has its centre in one before it; `inside` the window, if
 * that is wanted.
 */
export function emptyCircles(
  native: NativeShapes,
  window: NativeWindow,
  most: number,
  inside: boolean,
): EmptyCircle[] {
  const circles = inside
    ? innerCandidates(native, window)
    : candidatesOf(native, window).circles.sort(inOrder);
  return apart(circles, most);
}

/** The largest first. */
function inOrder(a: EmptyCircle, b: EmptyCircle): number {
  return b.r - a.r || a.x - b.x || a.y - b.y;
}

/** The candidates, first those at corners, then two for each edge, whose `sites` are pairs. */
function candidatesOf(native: NativeShapes, window: NativeWindow) {
  if (native.size() === 0) return { circles: [], corners: 0, sites: new Uint32Array() };
  const [region, , ...bounds] = window;
  const { curves, sites } = native.edgeCurves(region, null, ...bounds); // whatever cells reach
  const points = Array.from(cornersOf(native, window)); // x, y, x, y, …
  const corners = points.length / 2;
  for (let k = 0; k < curves.length; k += kOfCurve)
    points.push(curves[k]!, curves[k + 1]!, curves[k + 5]!, curves[k + 6]!);
  const circles: EmptyCircle[] = [];
  for (let k = 0; k < points.length; k += 2) {
    const [x, y] = [points[k]!, points[k + 1]!];
    const { id, distance } = native.nearest(x, y, Infinity);
    circles.push({ x, y, r: distance, site: id });
  }
  return { circles, corners, sites };
}

/** The largest first. */
function* innerCandidates(native: NativeShapes, window: NativeWindow): Generator<EmptyCircle> {
  const { circles, corners, sites } = candidatesOf(native, window);
  const cells = new Map(
    circles.map((circle, k) => {
      const edge = (k - corners) >> 1;
      return [circle, edge < 0 ? [circle.site] : sites.subarray(2 * edge, 2 * edge + 2)];
    }),
  );
  const [region, , ...bounds] = window;
  const obstacles = borderOf(native, window);
  const sides = Array.from({ length: obstacles.count }, (_, k) => k);
  const nearestCircle = finderOf(native, obstacles);
  const asked = new Set<number>(); // cells
  const places: EmptyCircle[] = []; // the best ones of these, the largest last
  for (const circle of circles.sort(inOrder)) {
    while (places.length > 0 && places.at(-1)!.r >= circle.r) yield places.pop()!;
    const { x, y, r } = circle;
    const room = nearestOf(obstacles.feet(sides, x, y)).distance;
    if (room >= r) {
      yield circle;
      continue;
    }
    for (const cell of cells.get(circle)!) {
      if (asked.has(cell)) continue;
      asked.add(cell);
      const { curves } = native.cellCurves(region, null, ...bounds, cell);
      if (curves.length === 0) continue; // too thin to have a part
      const best = widestPlace(obstacles, boxOf(curves), { x, y, r: room }, nearestCircle);
      places.push({ ...best, site: native.find(best.x, best.y) });
    }
    places.sort((a, b) => inOrder(b, a));
  }
  yield* places.reverse();
}

/** Finds the circles of sites, and adds those that are found to the obstacles. */
function finderOf(native: NativeShapes, obstacles: Obstacles): NearestCircle {
  const numbers = new Map<number, number>(); // by id
  return (x, y) => {
    const id = native.find(x, y);
    if (!numbers.has(id)) {
      const site = native.site(id);
      numbers.set(id, obstacles.addCircle(site.x, site.y, site.r));
    }
    return numbers.get(id)!;
  };
}

function borderOf(native: NativeShapes, window: NativeWindow): Obstacles {
  const border = new Obstacles();
  drawBounds(
    pathOfSides((...ends) => border.addSegment(...ends)),
    native,
    window,
  );
  return border;
}

/** The first `most` circles, none of which has its centre in one before it, or where that has. */
function apart(circles: Iterable<EmptyCircle>, most: number): EmptyCircle[] {
  const chosen: EmptyCircle[] = [];
  for (const circle of circles) {
    if (chosen.length >= most) break;
    const isApart = (one: EmptyCircle) => {
      const away = length(one.x - circle.x, one.y - circle.y);
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
