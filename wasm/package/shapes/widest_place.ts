// The place inside closed rings that is farthest from all obstacles: branch and bound over boxes.
// Obstacles are the rings' segments and further circles. A ring may be of chords that are off the
// curves that they stand for by a known slack.
//
// The distance D to an obstacle is convex, so over a box it is at most its largest value at the
// four corners. So is the mean of two of them, which no place can beat in both. Between two
// obstacles that face each other the mean is off by the square of the box's size only, where a
// single distance is off by the size.
//
// Of a segment, other convex functions that are not less than D serve better. With s the signed
// distance to its line, above 0 on the inside, and t the way by which the foot is beyond its ends,
// D <= |s| + t. Where s >= 0, that is s + t, which is linear across the line. Where s < 0, it is
// t - s; but if the only segment in a box runs all through it, nothing inside has s < 0. The same
// holds for each strip between two segments that run through a box side by side. So the boxes along
// a thin part of the domain may be as long as its segments, however thin it is.

import { ApolloniusError } from "../errors.js";
import { length } from "./curves.js";

/** Obstacles by number. */
export class Obstacles {
  /** x, y of both ends of each, the inside on the left; of a circle both are the centre. */
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

  /** Returns its number. */
  addCircle(x: number, y: number, r: number): number {
    this.ends.push(x, y, x, y);
    return this.radii.push(r) - 1;
  }

  /** An obstacle as seen from a point. */
  foot(k: number, x: number, y: number): Foot {
    const { ends } = this;
    const ax = ends[4 * k]!;
    const ay = ends[4 * k + 1]!;
    const dx = ends[4 * k + 2]! - ax;
    const dy = ends[4 * k + 3]! - ay;
    const square = dx * dx + dy * dy;
    const along = square > 0 ? ((x - ax) * dx + (y - ay) * dy) / square : 0;
    const t = Math.max(0, Math.min(1, along));
    const px = x - (ax + t * dx);
    const py = y - (ay + t * dy);
    const far = length(px, py);
    const r = this.radii[k]!;
    const distance = far - r;
    const [before, after] = [NaN, NaN];
    const foot = { k, x: x - px, y: y - py, r, distance, s: distance, ux: 0, uy: 0, before, after };
    if (square > 0 && t === along) {
      const whole = Math.sqrt(square);
      foot.ux = -dy / whole;
      foot.uy = dx / whole;
      foot.s = px * foot.ux + py * foot.uy;
      foot.before = t * whole;
      foot.after = whole - t * whole;
    } else if (far > 0) {
      foot.ux = px / far;
      foot.uy = py / far;
    }
    return foot;
  }

  feet(numbers: number[], x: number, y: number): Foot[] {
    return numbers.map((k) => this.foot(k, x, y));
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

  /** Does a segment lead through a box, or end in it, as far as the slack tells? */
  passage(k: number, box: Range): "none" | "through" | "end" {
    const { ends } = this;
    const w = box.width + this.slack;
    const h = box.height + this.slack;
    const ax = ends[4 * k]! - box.x;
    const ay = ends[4 * k + 1]! - box.y;
    const bx = ends[4 * k + 2]! - box.x;
    const by = ends[4 * k + 3]! - box.y;
    const isHere = (x: number, y: number) => Math.abs(x) <= w && Math.abs(y) <= h;
    const [dx, dy] = [bx - ax, by - ay];
    if (dx === 0 && dy === 0) return "none";
    if (isHere(ax, ay) || isHere(bx, by)) return "end";
    const isBeside =
      Math.abs(ax + bx) > 2 * w + Math.abs(dx) ||
      Math.abs(ay + by) > 2 * h + Math.abs(dy) ||
      Math.abs(dx * ay - dy * ax) > Math.abs(dy) * w + Math.abs(dx) * h;
    return isBeside ? "none" : "through";
  }
}

/** An obstacle as seen from a point. */
interface Foot {
  k: number;
  /** The nearest place of the segment, or the centre. */
  x: number;
  y: number;
  r: number;
  distance: number;
  /** The signed distance of the point to the segment's line; where there is no line, `distance`. */
  s: number;
  /** The unit vector in which s grows. */
  ux: number;
  uy: number;
  /** How far the segment goes on before and after the foot; NaN where there is no line. */
  before: number;
  after: number;
}

export type Box = readonly [xmin: number, ymin: number, xmax: number, ymax: number];

export interface Place {
  x: number;
  y: number;
  /** How far it is from all obstacles at least. */
  r: number;
}

/** The number of the circle that is nearest to a place: it becomes an obstacle when it is met. */
export type NearestCircle = (x: number, y: number) => number;

/** The share of r that is not looked for any more. */
const kShare = 2 ** -11;
/** The share of the coordinates below which doubles tell no difference. */
export const kGrain = 2 ** -50;
/** Parts looked at for each obstacle, at most. Cells at random take 3 to 20, thin rings 150. */
const kMostLooks = 2 ** 8;
/** Counted with the obstacles for that limit: a few of them need more parts each. */
const kMoreObstacles = 100;
/** The cosine up to which segments that do not cross in a box count as side by side. */
const kParallel = 0.9;

/**
 * Looks in a box for the place of the domain with the largest distance r to the nearest obstacle,
 * and returns that place, or `best` if it is better. The r of any other place of the domain in the
 * box is larger by at most kShare of r, kGrain of the coordinates, and two slacks (three, if r is
 * less than the slack). Throws "no-convergence". REQUIRES: all segments that meet the box are among
 * the obstacles.
 */
export function widestPlace(
  obstacles: Obstacles,
  box: Box,
  best: Place,
  nearestCircle?: NearestCircle,
): Place {
  const [xmin, ymin, xmax, ymax] = box;
  const grain = kGrain * Math.max(...box.map(Math.abs));
  const search = new Search(obstacles, nearestCircle, best, grain);
  const all = Array.from({ length: obstacles.count }, (_, k) => k);
  search.look((xmin + xmax) / 2, (ymin + ymax) / 2, (xmax - xmin) / 2, (ymax - ymin) / 2, all);
  while (search.parts.length > 0) {
    if (search.looks > kMostLooks * (obstacles.count + kMoreObstacles))
      throw new ApolloniusError("no-convergence", "sides of the window or cell nearly coincide");
    const wholes = search.parts;
    search.parts = [];
    for (const { x, y, width, height, most, near } of wholes) {
      if (search.isEnough(most)) continue; // a better place has been found since
      const isWide = width >= height;
      const [dx, dy] = isWide ? [width / 2, 0] : [0, height / 2];
      const [halfWidth, halfHeight] = [width - dx, height - dy];
      search.look(x - dx, y - dy, halfWidth, halfHeight, near);
      search.look(x + dx, y + dy, halfWidth, halfHeight, near);
    }
  }
  return search.best;
}

interface Range {
  x: number;
  y: number;
  // Half of its extents.
  width: number;
  height: number;
}

interface Part extends Range {
  /** No place in it is farther from all obstacles. */
  most: number;
  /** The obstacles that can be the nearest ones in it, or meet it. */
  near: number[];
}

class Search {
  best: Place;
  /** Where a better place can be. */
  parts: Part[] = [];
  looks = 0;
  readonly #obstacles: Obstacles;
  readonly #nearestCircle: NearestCircle | undefined;
  readonly #grain: number;

  constructor(
    obstacles: Obstacles,
    nearestCircle: NearestCircle | undefined,
    best: Place,
    grain: number,
  ) {
    this.#obstacles = obstacles;
    this.#nearestCircle = nearestCircle;
    this.best = best;
    this.#grain = grain;
  }

  /** Is nothing to be gained where no place has more than this? */
  isEnough(most: number): boolean {
    const { r } = this.best;
    const { slack } = this.#obstacles;
    // Two slacks are between the bound and the place itself. A third one saves looking along all
    // curves where r is less than the slack: less slack comes anyway.
    const share = r > slack ? kShare * r : kShare * Math.abs(r) + slack;
    return most - 2 * slack - r <= share + this.#grain;
  }

  /** Keeps a part, if a better place can be in it. No obstacles but `numbers` are near it. */
  look(x: number, y: number, width: number, height: number, numbers: number[]): void {
    ++this.looks;
    const { slack } = this.#obstacles;
    const reach = length(width, height);
    const all = this.#feet(numbers, x, y);
    const one = nearestOf(all);
    const feet = all.filter(({ distance }) => distance <= one.distance + 2 * (reach + slack));
    const part = { x, y, width, height, most: 0, near: feet.map(({ k }) => k) };
    const ways = part.near.map((k) => this.#obstacles.passage(k, part));
    const within = feet.filter((_, k) => ways[k] !== "none");
    const isInside = this.#obstacles.surround(x, y);
    if (!isInside && (within.length === 0 || one.distance - slack > reach)) return;
    this.#offer(x, y, one.distance);
    part.most = one.distance + reach + slack;
    if (this.isEnough(part.most)) return;
    const runThrough = !ways.includes("end");
    // If there is only one that runs through, what is inside is on its inside.
    const only = within.length === 1 && runThrough ? within[0] : undefined;
    const strips = runThrough ? this.#boundOfStrips(part, within) : Infinity;
    const bound = Math.min(this.#bound(part, feet, one, only), strips);
    part.most = Math.min(part.most, bound + slack);
    if (!this.isEnough(part.most)) this.parts.push(part);
  }

  /** Those of these obstacles, and of the circle that is nearest to a place. */
  #feet(numbers: number[], x: number, y: number): Foot[] {
    const circle = this.#nearestCircle?.(x, y);
    const isKnown = circle === undefined || numbers.includes(circle);
    return this.#obstacles.feet(isKnown ? numbers : [...numbers, circle], x, y);
  }

  /** Takes a place at this distance from the nearest obstacle, if it is inside and better. */
  #offer(x: number, y: number, distance: number): void {
    const r = distance - this.#obstacles.slack;
    if (r > this.best.r && this.#obstacles.surround(x, y)) this.best = { x, y, r };
  }

  /**
   * A bound of the distance to the nearest obstacle in a part: by that which is nearest to its
   * centre, alone or with another one. All that is inside is on the inside of `only`. Offers the
   * place in the middle between the two; where both are on one side, the corner on the other.
   */
  #bound(part: Part, feet: Foot[], one: Foot, only: Foot | undefined): number {
    const { x, y, width, height } = part;
    const ofPair = (other: Foot) => {
      const beyond = [one, other].filter((foot) => foot !== only);
      return Math.max(
        meanAtCorners(part, one, other),
        ...beyond.map((foot) => mostAtCorners(part, (px, py) => beyondLine(foot, px, py))),
      );
    };
    // The one that promises the least bound, as far as its slope at the centre tells.
    let other = one;
    let promised = Infinity;
    for (const foot of feet) {
      const slope = Math.abs(one.ux + foot.ux) * width + Math.abs(one.uy + foot.uy) * height;
      if (foot === one || foot.s + slope >= promised) continue;
      promised = foot.s + slope;
      other = foot;
    }
    const [dx, dy] = [x - one.x, y - one.y];
    if (dx * (x - other.x) + dy * (y - other.y) < 0)
      this.#try(part, (one.x + other.x) / 2, (one.y + other.y) / 2);
    else this.#try(part, x + Math.sign(dx) * width, y + Math.sign(dy) * height);
    return Math.min(ofPair(one), ofPair(other));
  }

  /**
   * A bound where what is inside, of a part, is strips side by side: each between two of its
   * segments, which all run through it. Infinity if it may be something else. Offers a place in the
   * middle of the widest strip.
   */
  #boundOfStrips(part: Part, segments: Foot[]): number {
    if (segments.length < 2) return Infinity;
    const { ux, uy } = segments[0]!;
    const facing = (foot: Foot) => foot.ux * ux + foot.uy * uy;
    if (!segments.every((foot) => foot.before >= 0 && Math.abs(facing(foot)) > kParallel))
      return Infinity;
    // Strips that are as thin as rounding vanish, so that no others seem to overlap.
    const across = (foot: Foot) =>
      (foot.x - part.x) * ux + (foot.y - part.y) * uy + Math.sign(facing(foot)) * this.#grain;
    segments.sort((a, b) => across(a) - across(b));
    const [first, last] = [segments[0]!, segments.at(-1)!];
    if (facing(first) < 0 && this.#isCornerInside(part, -ux, -uy)) return Infinity;
    if (facing(last) > 0 && this.#isCornerInside(part, ux, uy)) return Infinity;
    let most = -Infinity;
    segments.forEach((foot, k) => {
      const next = segments[k + 1];
      if (next === undefined || facing(foot) < 0 || facing(next) > 0) return;
      const mean = meanAtCorners(part, foot, next);
      if (!(mean > most)) return;
      most = mean;
      this.#try(part, (foot.x + next.x) / 2, (foot.y + next.y) / 2);
    });
    return most;
  }

  /** Is the corner inside that is farthest in a direction? */
  #isCornerInside({ x, y, width, height }: Part, ux: number, uy: number): boolean {
    return this.#obstacles.surround(x + (ux > 0 ? width : -width), y + (uy > 0 ? height : -height));
  }

  /** Offers a place, if it is in the circumcircle of a part: what is near a part is near that. */
  #try({ x, y, width, height, near }: Part, px: number, py: number): void {
    if (length(px - x, py - y) > length(width, height) * (1 + kGrain)) return;
    this.#offer(px, py, nearestOf(this.#feet(near, px, py)).distance);
  }
}

export function nearestOf(feet: Foot[]): Foot {
  return feet.reduce((one, other) => (other.distance < one.distance ? other : one));
}

function mostAtCorners({ x, y, width, height }: Part, at: (x: number, y: number) => number) {
  return Math.max(
    at(x - width, y - height),
    at(x + width, y - height),
    at(x - width, y + height),
    at(x + width, y + height),
  );
}

function meanAtCorners(part: Part, one: Foot, other: Foot): number {
  return mostAtCorners(part, (x, y) => (convexAbove(one, x, y) + convexAbove(other, x, y)) / 2);
}

/** s + t; where there is no line, the distance. */
function convexAbove(foot: Foot, x: number, y: number): number {
  const [s, t] = fromLine(foot, x, y);
  return t >= 0 ? s + t : length(x - foot.x, y - foot.y) - foot.r;
}

/** t - s; where there is no line, nothing. */
function beyondLine(foot: Foot, x: number, y: number): number {
  const [s, t] = fromLine(foot, x, y);
  return t >= 0 ? t - s : -Infinity;
}

/** s and t; NaN where there is no line. */
function fromLine({ x, y, ux, uy, before, after }: Foot, px: number, py: number) {
  const along = (px - x) * uy - (py - y) * ux;
  return [(px - x) * ux + (py - y) * uy, Math.max(0, along - after, -along - before)] as const;
}
