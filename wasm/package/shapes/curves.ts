// Curves in numbers: places and directions on the rational quadratic curves of `edgeCurves` and
// `cellCurves`.
import { described, isArrayLike } from "../core/arguments.js";
import { ApolloniusError } from "../errors.js";

/** Numbers of a curve: from, control point, weight, to. */
export const kOfCurve = 7;

/**
 * The point of curve `k` at a parameter from 0 (its start) to 1. Along a straight segment (w = 0),
 * as along any curve, the parameter does not run evenly. Throws "out-of-range" if there is no such
 * curve, "bad-length" if `curves` is no array, as what `cellCurves` returns: its `curves` are one.
 */
export function curvePoint(
  curves: ArrayLike<number>,
  k: number,
  t: number,
): [x: number, y: number] {
  const [x0, y0, x1, y1, w, x2, y2] = sevenOf(curves, k);
  const s = 1 - t;
  const [a, b, c] = [s * s, 2 * w * t * s, t * t];
  const sum = a + b + c;
  return [(a * x0 + b * x1 + c * x2) / sum, (a * y0 + b * y1 + c * y2) / sum];
}

/** The unit tangent of curve `k` at a parameter, forwards. Throws as `curvePoint`. */
export function curveTangent(
  curves: ArrayLike<number>,
  k: number,
  t: number,
): [x: number, y: number] {
  const [x0, y0, x1, y1, w, x2, y2] = sevenOf(curves, k);
  // The quotient rule's numerator, with the higher terms cancelled; a segment has one direction
  // everywhere.
  const s = 1 - t;
  const [a, b, c] = w === 0 ? [0, 1, 0] : [w * s * s, t * s, w * t * t];
  const x = a * (x1 - x0) + b * (x2 - x0) + c * (x2 - x1);
  const y = a * (y1 - y0) + b * (y2 - y0) + c * (y2 - y1);
  // Not Math.hypot: every engine rounds it in its own way. Divided first, as squares of large and
  // of small numbers do not exist.
  const larger = Math.max(Math.abs(x), Math.abs(y));
  const [u, v] = [x / larger, y / larger];
  const length = Math.sqrt(u * u + v * v);
  return [u / length, v / length];
}

/** Not Math.hypot: every engine rounds it in its own way. */
export function length(x: number, y: number): number {
  return Math.sqrt(x * x + y * y);
}

/** A curve cut in the middle of its arc: (x, y), towards which a and b are the control points. */
export interface Halves {
  ax: number;
  ay: number;
  x: number;
  y: number;
  bx: number;
  by: number;
  /** The weight of both. */
  w: number;
}

export function halved(
  x0: number,
  y0: number,
  x1: number,
  y1: number,
  w: number,
  x2: number,
  y2: number,
): Halves {
  const u = 1 / (1 + w);
  const v = w * u; // not w times a coordinate, which may be no double
  const ax = u * x0 + v * x1;
  const ay = u * y0 + v * y1;
  const bx = u * x2 + v * x1;
  const by = u * y2 + v * y1;
  return { ax, ay, x: (ax + bx) / 2, y: (ay + by) / 2, bx, by, w: Math.sqrt((1 + w) / 2) };
}

type Seven = [x0: number, y0: number, x1: number, y1: number, w: number, x2: number, y2: number];

export function sevenOf(curves: ArrayLike<number>, k: number): Seven {
  if (!isArrayLike(curves))
    throw new ApolloniusError(
      "bad-length",
      `curves is ${described(curves)}, expected an array, as \`curves\` of cellCurves is`,
    );
  const count = Math.floor(curves.length / kOfCurve);
  if (!(Number.isInteger(k) && k >= 0 && k < count))
    throw new ApolloniusError(
      "out-of-range",
      `k is ${described(k)}, expected the number of one of ${count} curves`,
    );
  return Array.from({ length: kOfCurve }, (_, n) => curves[kOfCurve * k + n] as number) as Seven;
}
