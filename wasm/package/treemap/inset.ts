// A polygon without a strip along its border: each side moves inwards, sides that become shorter
// than nothing leave, and their neighbours meet.
import type { Rings } from "./outline.js";
import { momentsOf } from "./rings.js";

const kMostHalvings = 40;
/** Share of the whole: less is what rounding leaves of nothing. */
const kLeast = 2 ** -30;

/** Strips of this width, or of half of it, or a quarter, …, where the rest would not be whole. */
export function inset(rings: Rings, width: number): Rings {
  if (!(width > 0)) return rings;
  const whole = momentsOf(rings).area;
  for (let halvings = 0; halvings < kMostHalvings; ++halvings, width /= 2) {
    const rest = rings.map((ring) => insetRing(ring, width));
    if (rest.some((ring) => ring === null)) continue;
    const area = momentsOf(rest as Rings).area;
    const isWhole =
      area > kLeast * whole && area < whole && !hasCrossings([...rings, ...(rest as Rings)]);
    if (isWhole) return rest as Rings;
  }
  return rings;
}

/** A side: a point of its line and its direction, of length 1. */
interface Side {
  readonly x: number;
  readonly y: number;
  readonly dx: number;
  readonly dy: number;
}

/** Where the lines of two sides that follow each other meet, so far to their left. */
function corner(a: Side, b: Side, width: number): [number, number] {
  const turn = a.dx * b.dy - a.dy * b.dx;
  const [x, y] = [b.x - width * b.dy, b.y + width * b.dx];
  if (Math.abs(turn) < 1e-9) return [x, y]; // one line
  const t = ((x - a.x + width * a.dy) * b.dy - (y - a.y - width * a.dx) * b.dx) / turn;
  return [a.x - width * a.dy + t * a.dx, a.y + width * a.dx + t * a.dy];
}

/**
 * How long a side is between its neighbours, so far to the left; negative if it has turned round.
 */
function lengthOf(before: Side, side: Side, after: Side, width: number): number {
  const [ax, ay] = corner(before, side, width);
  const [bx, by] = corner(side, after, width);
  return (bx - ax) * side.dx + (by - ay) * side.dy;
}

/** Sides moved to their left; null if fewer than three are left. */
function insetRing(ring: Float64Array, width: number): Float64Array | null {
  const sides: Side[] = [];
  for (let k = 0; k < ring.length; k += 2) {
    const next = (k + 2) % ring.length;
    const [x, y] = [ring[k]!, ring[k + 1]!];
    const [dx, dy] = [ring[next]! - x, ring[next + 1]! - y];
    const length = Math.sqrt(dx * dx + dy * dy);
    if (length > 0) sides.push({ x, y, dx: dx / length, dy: dy / length });
  }
  const at = (k: number) => sides[(k + sides.length) % sides.length]!;
  // The part of the way after which each side has turned round; the first one leaves, after which
  // its neighbours meet.
  const lastingOf = (k: number) => {
    const length = lengthOf(at(k - 1), at(k), at(k + 1), width);
    if (length >= 0) return Infinity;
    const before = lengthOf(at(k - 1), at(k), at(k + 1), 0);
    return before > 0 ? before / (before - length) : 0;
  };
  const lasting = sides.map((_, k) => lastingOf(k));
  while (sides.length >= 3) {
    const first = lasting.reduce((least, time, k) => (time < lasting[least]! ? k : least), 0);
    if (lasting[first] === Infinity)
      return Float64Array.from(sides.flatMap((side, k) => corner(at(k - 1), side, width)));
    sides.splice(first, 1);
    lasting.splice(first, 1);
    for (const k of [first - 1, first]) {
      const own = (k + sides.length) % sides.length;
      lasting[own] = lastingOf(own);
    }
  }
  return null;
}

/** Does any side cross another one? */
function hasCrossings(rings: Rings): boolean {
  const sides: [number, number, number, number][] = [];
  for (const ring of rings) {
    for (let k = 0, last = ring.length - 2; k < ring.length; last = k, k += 2)
      sides.push([ring[last]!, ring[last + 1]!, ring[k]!, ring[k + 1]!]);
  }
  // From left to right, each with those that begin before it ends.
  const left = ([ax, , bx]: [number, number, number, number]) => Math.min(ax, bx);
  const right = ([ax, , bx]: [number, number, number, number]) => Math.max(ax, bx);
  sides.sort((a, b) => left(a) - left(b));
  return sides.some((a, k) => {
    for (let other = k + 1; other < sides.length; ++other) {
      const b = sides[other]!;
      if (left(b) > right(a)) return false;
      if (doCross(a, b)) return true;
    }
    return false;
  });
}

function doCross(
  [ax, ay, bx, by]: [number, number, number, number],
  [cx, cy, dx, dy]: [number, number, number, number],
): boolean {
  const side = (px: number, py: number, qx: number, qy: number, x: number, y: number) =>
    (qx - px) * (y - py) - (qy - py) * (x - px);
  return (
    side(ax, ay, bx, by, cx, cy) * side(ax, ay, bx, by, dx, dy) < 0 &&
    side(cx, cy, dx, dy, ax, ay) * side(cx, cy, dx, dy, bx, by) < 0
  );
}
