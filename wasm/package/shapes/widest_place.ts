// The place that is farthest from all obstacles: branch and bound over boxes. Obstacles are
// segments, points and circles, and curves as chords that are off by a known slack.
//
// The distance D to an obstacle is convex, so over a box it is at most its largest value at the
// four corners; so is the mean of two of them, which no place can beat in both. Between two
// obstacles that face each other that bound is off by the square of the box's size only, where the
// distance to a single one is off by the size: so a long corridor needs few boxes.
//
// Of a segment, convex functions that are not less than D do it as well. With s the signed distance
// to its line, above 0 on the side of the box's centre, and t the way by which the foot is beyond
// its ends, D <= |s| + t. Where s >= 0, that is s + t, which is linear across the segment, also
// beyond its line, where corners of the box are; and where s < 0, it is t - s. So the largest of
// both at the corners bounds D, and in the mean of two obstacles s + t counts.

/** Obstacles by number. */
export class Obstacles {
  /** x, y of both ends of each; of a circle both are the centre. */
  readonly ends: number[] = [];
  /** Radii of circles; 0 of segments. */
  readonly radii: number[] = [];
  /** How far segments may be from what they stand for. */
  slack = 0;

  get count(): number {
    return this.radii.length;
  }

  addSegment(x0: number, y0: number, x1: number, y1: number): void {
    this.ends.push(x0, y0, x1, y1);
    this.radii.push(0);
  }

  addCircle(x: number, y: number, r: number): void {
    this.ends.push(x, y, x, y);
    this.radii.push(r);
  }

  distance(k: number, x: number, y: number): number {
    const { ends } = this;
    const dx = ends[4 * k + 2]! - ends[4 * k]!;
    const dy = ends[4 * k + 3]! - ends[4 * k + 1]!;
    const px = x - ends[4 * k]!;
    const py = y - ends[4 * k + 1]!;
    const square = dx * dx + dy * dy;
    const t = square > 0 ? Math.max(0, Math.min(1, (px * dx + py * dy) / square)) : 0;
    return length(px - t * dx, py - t * dy) - this.radii[k]!;
  }

  /** The least distance of those with these numbers; infinity of none. */
  leastDistance(from: number, to: number, x: number, y: number): number {
    let least = Infinity;
    for (let k = from; k < to; ++k) least = Math.min(least, this.distance(k, x, y));
    return least;
  }

  /** Is a point inside the rings that all segments make? By the even-odd rule. */
  surround(x: number, y: number): boolean {
    const { ends } = this;
    let isInside = false;
    for (let k = 0; k < ends.length; k += 4) {
      const ax = ends[k]!;
      const ay = ends[k + 1]!;
      const bx = ends[k + 2]!;
      const by = ends[k + 3]!;
      if (ay > y !== by > y && x < ax + ((bx - ax) * (y - ay)) / (by - ay)) isInside = !isInside;
    }
    return isInside;
  }
}

export type Box = readonly [xmin: number, ymin: number, xmax: number, ymax: number];

export interface Place {
  x: number;
  y: number;
  /** How far it is from all obstacles at least. */
  r: number;
}

/**
 * Is null in the domain of places, else a distance within which nothing of it is; `nearest` is the
 * distance to the nearest obstacle.
 */
export type Outside = (x: number, y: number, nearest: number) => number | null;

/** No other place has an r that is larger by more than that share of it. */
const kShare = 2 ** -11;

/**
 * Finds the place of the domain in a box whose distance r to the nearest obstacle is as large as
 * can be, but for two slacks and kShare, or keeps `best` if that is as good. null if there is none:
 * no double is in the domain. Also a box of all places that can be better than it, as far as is
 * known: where to look on with less slack.
 */
export function widestPlace(
  obstacles: Obstacles,
  [xmin, ymin, xmax, ymax]: Box,
  outside: Outside,
  best: Place | null = null,
): { best: Place | null; rest: Box } {
  const search = new Search(obstacles, outside, best);
  const all = Array.from({ length: obstacles.count }, (_, k) => k);
  let parts: Part[] = [];
  const look = (x: number, y: number, width: number, height: number, near: number[]) => {
    const part = search.look(x, y, width, height, near);
    if (part !== null) parts.push(part);
  };
  look((xmin + xmax) / 2, (ymin + ymax) / 2, (xmax - xmin) / 2, (ymax - ymin) / 2, all);
  while (parts.length > 0) {
    const wholes = parts;
    parts = [];
    for (const whole of wholes) {
      const { x, y, width, height, near } = whole;
      const isWide = width >= height;
      const [dx, dy] = isWide ? [width / 2, 0] : [0, height / 2];
      if (search.leaves(whole) || (x + dx === x && y + dy === y)) continue;
      const [halfWidth, halfHeight] = isWide ? [dx, height] : [width, dy];
      look(x - dx, y - dy, halfWidth, halfHeight, near);
      look(x + dx, y + dy, halfWidth, halfHeight, near);
    }
  }
  return { best: search.best, rest: search.rest() };
}

interface Range {
  x: number;
  y: number;
  // Half of its extents.
  width: number;
  height: number;
  /** No place in it is farther from all obstacles. */
  most: number;
}

interface Part extends Range {
  /** The obstacles that can be the nearest ones in it. */
  near: number[];
}

/** An obstacle as seen from a point: the nearest place on it. */
interface Foot {
  x: number;
  y: number;
  distance: number;
  /** The unit vector from there to the point. */
  ux: number;
  uy: number;
  /** How far its ends are along the segment, before and after; at an end, and of a circle, none. */
  before: number;
  after: number;
  r: number;
}

class Search {
  best: Place | null;
  readonly #obstacles: Obstacles;
  readonly #outside: Outside;
  /** What has been left, though it may have a better place. */
  readonly #left: Range[] = [];

  constructor(obstacles: Obstacles, outside: Outside, best: Place | null) {
    this.#obstacles = obstacles;
    this.#outside = outside;
    this.best = best;
  }

  /** Is a part left, as nothing is to be gained in it? What is left for its slack is noted. */
  leaves({ x, y, width, height, most }: Range): boolean {
    if (this.best === null) return false;
    const { r } = this.best;
    if (most - 2 * this.#obstacles.slack > r + kShare * Math.abs(r)) return false;
    if (most > r) this.#left.push({ x, y, width, height, most });
    return true;
  }

  /** A box around the best place, and all that may be better. */
  rest(): Box {
    const { x, y, r } = this.best ?? { x: Infinity, y: Infinity, r: -Infinity };
    let [xmin, ymin, xmax, ymax] = [x, y, this.best ? x : -Infinity, this.best ? y : -Infinity];
    for (const part of this.#left) {
      if (part.most <= r) continue;
      xmin = Math.min(xmin, part.x - part.width);
      ymin = Math.min(ymin, part.y - part.height);
      xmax = Math.max(xmax, part.x + part.width);
      ymax = Math.max(ymax, part.y + part.height);
    }
    return [xmin, ymin, xmax, ymax];
  }

  /** The part about a point, which may be the best place; null if it has no better one. */
  look(x: number, y: number, width: number, height: number, candidates: number[]): Part | null {
    const { slack } = this.#obstacles;
    const reach = Math.sqrt(width * width + height * height);
    const distances: number[] = [];
    let nearest = Infinity;
    let nearestOne = -1;
    for (const k of candidates) {
      const distance = this.#obstacles.distance(k, x, y);
      distances.push(distance);
      if (distance >= nearest) continue;
      nearest = distance;
      nearestOne = k;
    }
    const r = nearest - slack;
    const away = this.#outside(x, y, r);
    if (away !== null && away > reach) return null;
    if (away === null && r > (this.best?.r ?? -Infinity)) this.best = { x, y, r };
    const range = { x, y, width, height, most: nearest + reach + slack };
    if (this.leaves(range)) return null;
    const near = candidates.filter((_, k) => distances[k]! <= nearest + 2 * reach);
    const bound = this.#bound(x, y, width, height, nearestOne, near);
    range.most = Math.min(range.most, bound + slack);
    return this.leaves(range) ? null : { ...range, near };
  }

  /** A bound of the distance to the nearest obstacle in a box: by the nearest and another one. */
  #bound(x: number, y: number, width: number, height: number, nearest: number, near: number[]) {
    const one = this.#footOf(nearest, x, y);
    let other = one;
    // The one that promises the least bound, as far as its slope at the centre tells.
    let promised = Infinity;
    for (const k of near) {
      const foot = this.#footOf(k, x, y);
      const slope = Math.abs(one.ux + foot.ux) * width + Math.abs(one.uy + foot.uy) * height;
      if (foot.distance + slope >= promised) continue;
      promised = foot.distance + slope;
      other = foot;
    }
    let most = -Infinity;
    for (let corner = 0; corner < 4; ++corner) {
      const px = x + (corner & 1 ? width : -width);
      const py = y + (corner & 2 ? height : -height);
      const mean = (convexAbove(one, px, py) + convexAbove(other, px, py)) / 2;
      most = Math.max(most, mean, beyondLine(one, px, py), beyondLine(other, px, py));
    }
    return most;
  }

  #footOf(k: number, x: number, y: number): Foot {
    const { ends, radii } = this.#obstacles;
    const ax = ends[4 * k]!;
    const ay = ends[4 * k + 1]!;
    const dx = ends[4 * k + 2]! - ax;
    const dy = ends[4 * k + 3]! - ay;
    const square = dx * dx + dy * dy;
    const along = square > 0 ? ((x - ax) * dx + (y - ay) * dy) / square : 0;
    const t = Math.max(0, Math.min(1, along));
    const fx = ax + t * dx;
    const fy = ay + t * dy;
    const far = length(x - fx, y - fy);
    const ux = far > 0 ? (x - fx) / far : 0;
    const uy = far > 0 ? (y - fy) / far : 0;
    const isLine = t === along && square > 0 && far > 0;
    const whole = isLine ? Math.sqrt(square) : NaN;
    const before = t * whole;
    const after = (1 - t) * whole;
    // Along (-uy, ux) the segment's ends may be the other way round.
    const isTurned = ux * dy - uy * dx < 0;
    return {
      x: fx,
      y: fy,
      distance: far - radii[k]!,
      ux,
      uy,
      before: isTurned ? after : before,
      after: isTurned ? before : after,
      r: radii[k]!,
    };
  }
}

/** Not Math.hypot: every engine rounds it in its own way. */
export function length(x: number, y: number): number {
  return Math.sqrt(x * x + y * y);
}

/** s + t, and of a point the distance. */
function convexAbove(foot: Foot, x: number, y: number): number {
  const px = x - foot.x;
  const py = y - foot.y;
  if (Number.isNaN(foot.before)) return length(px, py) - foot.r;
  return px * foot.ux + py * foot.uy + overshoot(foot, px, py);
}

/** t - s; of a point there is no such side. */
function beyondLine(foot: Foot, x: number, y: number): number {
  const px = x - foot.x;
  const py = y - foot.y;
  if (Number.isNaN(foot.before)) return -Infinity;
  return overshoot(foot, px, py) - (px * foot.ux + py * foot.uy);
}

function overshoot(foot: Foot, px: number, py: number): number {
  const along = py * foot.ux - px * foot.uy;
  return Math.max(0, along - foot.after, -along - foot.before);
}
