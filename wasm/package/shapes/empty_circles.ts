// Empty circles with their centres in a window: the places that are farthest from all sites.
//
// Along an edge, and along a straight side of the window inside one cell, the distance to the
// nearest site is convex, so it is largest at an end. Hence the candidates are Voronoi vertices in
// the window, the points where edges cross its border, and its corners. All but the corners are the
// ends of the edges as the window clips them.
//
// Circles inside the window must not reach beyond its border either. A candidate that does not is
// one of these circles. In the cells around the others there may be a place where the nearest site
// and the border are about equally far: that is looked for (widest_place.ts), cell by cell, in the
// order of what a cell can have at most, and no further than circles are wanted.
import type { NativeShapes } from "../core/native/module.js";
import { kOfCurve } from "./curves.js";
import { drawBounds, type NativeWindow } from "./drawing.js";
import { boxOf } from "./inner_circle.js";
import type { EmptyCircle } from "./types.js";
import { Obstacles, type Place, widestPlace } from "./widest_place.js";

/** The `most` largest ones, none of which has its centre in one before it. */
export function emptyCircles(
  native: NativeShapes,
  window: NativeWindow,
  most: number,
): EmptyCircle[] {
  return apart(candidatesOf(native, window).sort(inOrder), most, between).map(withoutCells);
}

/** The largest first. */
function inOrder(a: EmptyCircle, b: EmptyCircle): number {
  return b.r - a.r || a.x - b.x || a.y - b.y;
}

function between(a: EmptyCircle, b: EmptyCircle): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

function withoutCells({ x, y, r, site }: EmptyCircle): EmptyCircle {
  return { x, y, r, site };
}

function candidatesOf(native: NativeShapes, window: NativeWindow): Candidate[] {
  if (native.size() === 0) return [];
  const [region, , ...bounds] = window;
  const { curves, sites } = native.edgeCurves(region, null, ...bounds); // whatever cells reach
  const corners = cornersOf(native, window);
  const xy = new Float64Array(corners.length + (4 * curves.length) / kOfCurve);
  xy.set(corners);
  for (let from = 0, to = corners.length; from < curves.length; from += kOfCurve, to += 4) {
    xy.set(curves.subarray(from, from + 2), to);
    xy.set(curves.subarray(from + 5, from + 7), to + 2);
  }
  const candidates: Candidate[] = [];
  for (let k = 0; k < xy.length; k += 2) {
    const [x, y] = [xy[k]!, xy[k + 1]!];
    const { id, distance } = native.nearest(x, y);
    const edge = Math.floor((k - corners.length) / 4);
    const cells = edge < 0 ? [id] : [sites[2 * edge]!, sites[2 * edge + 1]!];
    candidates.push({ x, y, r: distance, site: id, cells });
  }
  return candidates;
}

/** An empty circle, and the sites whose cells its centre is known to be on. */
interface Candidate extends EmptyCircle {
  cells: readonly number[];
}

/** The `most` largest ones inside the window, likewise. */
export function innerEmptyCircles(
  native: NativeShapes,
  window: NativeWindow,
  most: number,
): EmptyCircle[] {
  return apart(innerCandidates(native, window), most, between).map(withoutCells);
}

/** The largest first. */
function* innerCandidates(native: NativeShapes, window: NativeWindow): Generator<EmptyCircle> {
  const border = borderOf(native, window);
  const asked = new Set<number>(); // cells
  const places: EmptyCircle[] = []; // the best ones of these, the largest last
  for (const candidate of candidatesOf(native, window).sort(inOrder)) {
    while (places.length > 0 && places.at(-1)!.r >= candidate.r) yield places.pop()!;
    const { x, y, r } = candidate;
    if (border.leastDistance(0, border.count, x, y) >= r) {
      yield candidate;
      continue;
    }
    for (const site of candidate.cells) {
      if (asked.has(site)) continue;
      asked.add(site);
      const place = bestOfCell(native, window, border, site, r);
      if (place !== null) places.push({ ...place, site });
    }
    places.sort((a, b) => inOrder(b, a));
  }
  yield* places.reverse();
}

/**
 * The place in a cell that is farthest from its site and the window's border; null if doubles are
 * too far apart to have one. `most`: no place in it is farther from the site.
 */
function bestOfCell(
  native: NativeShapes,
  window: NativeWindow,
  border: Obstacles,
  site: number,
  most: number,
): Place | null {
  const [region, , ...bounds] = window;
  const box = boxOf(native.cellCurves(region, null, ...bounds, site).curves);
  const [xmin, ymin, xmax, ymax] = box;
  const obstacles = new Obstacles();
  for (const id of [site, ...native.neighbors(site)]) {
    const { x, y, r } = native.site(id);
    obstacles.addCircle(x, y, r);
  }
  const sites = obstacles.count;
  for (let k = 0; k < border.count; ++k) {
    const [x0, y0, x1, y1] = border.ends.slice(4 * k, 4 * k + 4) as [
      number,
      number,
      number,
      number,
    ];
    const isFar =
      Math.min(x0, x1) - xmax > most ||
      xmin - Math.max(x0, x1) > most ||
      Math.min(y0, y1) - ymax > most ||
      ymin - Math.max(y0, y1) > most;
    if (!isFar) obstacles.addSegment(x0, y0, x1, y1);
  }
  const outside = (x: number, y: number) => {
    if (!border.surround(x, y))
      return Math.min(most, obstacles.leastDistance(sites, obstacles.count, x, y));
    // Distances change by no more than the way to the cell does.
    const ahead = obstacles.distance(0, x, y) - obstacles.leastDistance(1, sites, x, y);
    return ahead > 0 ? ahead / 2 : null;
  };
  return widestPlace(obstacles, box, outside).best;
}

function borderOf(native: NativeShapes, window: NativeWindow): Obstacles {
  const border = new Obstacles();
  let [firstX, firstY, atX, atY] = [0, 0, 0, 0];
  const lineTo = (x: number, y: number) => {
    border.addSegment(atX, atY, x, y);
    [atX, atY] = [x, y];
  };
  const moveTo = (x: number, y: number) => {
    [firstX, firstY, atX, atY] = [x, y, x, y];
  };
  const nothing = () => {};
  const closePath = () => lineTo(firstX, firstY);
  drawBounds({ moveTo, lineTo, closePath, bezierCurveTo: nothing }, native, window);
  return border;
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
