// Polygons as windows: their measures, what is inside, frames to compute in.
import type { Outline, Rings } from "./outline.js";

/**
 * A place and a scale, a power of two: of what has the coordinates (x, y) in it at x0 + scale x.
 */
export interface Frame {
  readonly x: number;
  readonly y: number;
  readonly scale: number;
}

export interface Box {
  readonly xmin: number;
  readonly ymin: number;
  readonly xmax: number;
  readonly ymax: number;
}

export function boxOf(rings: Rings): Box {
  let [xmin, ymin, xmax, ymax] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const ring of rings) {
    for (let k = 0; k < ring.length; k += 2) {
      const x = ring[k]!;
      const y = ring[k + 1]!;
      if (x < xmin) xmin = x;
      if (x > xmax) xmax = x;
      if (y < ymin) ymin = y;
      if (y > ymax) ymax = y;
    }
  }
  return { xmin, ymin, xmax, ymax };
}

/** The frame, in the coordinates of a box, in which its larger side is from 1 to 2. */
export function frameOf({ xmin, ymin, xmax, ymax }: Box): Frame {
  const side = Math.max(xmax - xmin, ymax - ymin);
  let scale = 1;
  while (side < scale) scale /= 2;
  while (side >= 2 * scale) scale *= 2;
  return { x: (xmin + xmax) / 2, y: (ymin + ymax) / 2, scale };
}

/** Numbers of one frame in another one that is given in its coordinates. */
export function movedInto({ x, y, scale }: Frame, rings: Rings): Rings {
  return rings.map((ring) => {
    const moved = new Float64Array(ring.length);
    for (let k = 0; k < ring.length; k += 2) {
      moved[k] = (ring[k]! - x) / scale;
      moved[k + 1] = (ring[k + 1]! - y) / scale;
    }
    return moved;
  });
}

/** As rings, for curves, whose fifth number of seven is a weight. */
export function curvesMovedInto(frame: Frame, { curves, starts }: Outline): Outline {
  const moved = curves.map((value, k) => {
    const part = k % 7;
    if (part === 4) return value;
    const isX = part === 0 || part === 2 || part === 5;
    return (value - (isX ? frame.x : frame.y)) / frame.scale;
  });
  return { curves: moved, starts };
}

/** A frame in the coordinates of another one, in those of the latter. */
export function composed(outer: Frame, inner: Frame): Frame {
  return {
    x: outer.x + outer.scale * inner.x,
    y: outer.y + outer.scale * inner.y,
    scale: outer.scale * inner.scale,
  };
}

/** The signed area, and where its centre of gravity is. */
export function momentsOf(rings: Rings): { area: number; x: number; y: number } {
  let [area, x, y] = [0, 0, 0];
  for (const ring of rings) {
    for (let k = 0, last = ring.length - 2; k < ring.length; last = k, k += 2) {
      const ax = ring[last]!;
      const ay = ring[last + 1]!;
      const bx = ring[k]!;
      const by = ring[k + 1]!;
      const piece = (ax * by - bx * ay) / 2;
      area += piece;
      x += (piece * (ax + bx)) / 3;
      y += (piece * (ay + by)) / 3;
    }
  }
  return { area, x: x / area, y: y / area };
}

/** Share of the two products of a turn that the rounding of their difference cannot exceed. */
const kRounding = 2 ** -51;

/** A line of constant y, with the sides of rings that cross it or run along it. */
export class Row {
  readonly y: number;
  readonly #sides: number[] = []; // ax, ay, bx, by of each

  constructor(rings: Rings, y: number) {
    this.y = y;
    for (const ring of rings) {
      for (let k = 0, last = ring.length - 2; k < ring.length; last = k, k += 2) {
        const ay = ring[last + 1]!;
        const by = ring[k + 1]!;
        if (ay > y !== by > y || (ay === y && by === y))
          this.#sides.push(ring[last]!, ay, ring[k]!, by);
      }
    }
  }

  /**
   * Is its place at x inside, by the even-odd rule, for sure? Not on the border, nor so close to it
   * that rounding may have put it there.
   */
  isInside(x: number): boolean {
    const { y } = this;
    const sides = this.#sides;
    let inside = false;
    for (let k = 0; k < sides.length; k += 4) {
      const ax = sides[k]!;
      const ay = sides[k + 1]!;
      const bx = sides[k + 2]!;
      const by = sides[k + 3]!;
      if (ay === by) {
        if (x >= Math.min(ax, bx) && x <= Math.max(ax, bx)) return false;
        continue;
      }
      const left = (bx - ax) * (y - ay);
      const right = (by - ay) * (x - ax);
      if (!(Math.abs(left - right) > kRounding * (Math.abs(left) + Math.abs(right)))) return false;
      if (left > right === by > ay) inside = !inside;
    }
    return inside;
  }

  /** Its pieces inside: where they begin and end, by turns. */
  crossings(): number[] {
    const { y } = this;
    const sides = this.#sides;
    const crossings: number[] = [];
    for (let k = 0; k < sides.length; k += 4) {
      const ay = sides[k + 1]!;
      const by = sides[k + 3]!;
      if (ay === by) continue;
      crossings.push(sides[k]! + ((y - ay) / (by - ay)) * (sides[k + 2]! - sides[k]!));
    }
    return crossings.sort((a, b) => a - b);
  }
}

/** Is a place inside for sure? */
export function isInside(rings: Rings, x: number, y: number): boolean {
  return new Row(rings, y).isInside(x);
}

/** All rings as one, closed: to each further ring and around it, then back the same way. */
export function joined(rings: Rings, { x, y, scale }: Frame): [number, number][] {
  const points: [number, number][] = [];
  const add = (ring: Float64Array, k: number) =>
    points.push([x + scale * ring[k]!, y + scale * ring[k + 1]!]);
  for (const ring of rings) {
    for (let k = 0; k < ring.length; k += 2) add(ring, k);
    add(ring, 0);
  }
  for (let k = rings.length - 2; k >= 0; --k) add(rings[k]!, 0);
  return points;
}
