// Boundaries of cells: rings of curves, as `cellCurves` gives them, and polygons of the same area.
import { halved } from "../shapes/curves.js";

/** Rings of curves x0, y0, x1, y1, w, x2, y2 (w = 0: a segment), and where each ring starts. */
export interface Outline {
  readonly curves: Float64Array;
  readonly starts: Uint32Array;
}

/** Rings x, y, …, not closed by their first point again; their insides are on their left. */
export type Rings = readonly Float64Array[];

const kDeepest = 16;

/**
 * The area between a conic of this weight and its chord, as a share of the triangle of its control
 * points: the triangle of the shoulder, and twice as much of each half; 2/3 of a parabola, w = 1.
 */
function shareOfTriangle(w: number): number {
  let sum = 0;
  let factor = 1;
  for (let depth = 0; depth < kDeepest; ++depth) {
    const part = w / (1 + w);
    sum += factor * part;
    factor *= part / (1 + w);
    w = Math.sqrt((1 + w) / 2);
  }
  return sum + (factor * 2) / 3;
}

/** Twice the signed area of a triangle. */
function cross(ax: number, ay: number, bx: number, by: number, cx: number, cy: number): number {
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}

/**
 * Adds the points between the ends of a conic, so that chords are within the tolerance: its
 * shoulder, and those of its halves.
 */
function addInner(
  points: number[],
  x0: number,
  y0: number,
  x1: number,
  y1: number,
  w: number,
  x2: number,
  y2: number,
  square: number, // of the tolerance
  depth: number,
): void {
  const { ax, ay, x, y, bx, by, w: half } = halved(x0, y0, x1, y1, w, x2, y2);
  const dx = x - (x0 + x2) / 2;
  const dy = y - (y0 + y2) / 2;
  if (depth > 0 && (depth === kDeepest || !(dx * dx + dy * dy > square))) return;
  addInner(points, x0, y0, ax, ay, half, x, y, square, depth + 1);
  points.push(x, y);
  addInner(points, x, y, bx, by, half, x2, y2, square, depth + 1);
}

/**
 * The points of a curve but for its end. Those inside are moved away from the chord, or towards it,
 * in one proportion, so that the area between is the curve's.
 */
function addCurve(points: number[], curves: Float64Array, at: number, tolerance: number): void {
  const x0 = curves[at]!;
  const y0 = curves[at + 1]!;
  points.push(x0, y0);
  const w = curves[at + 4]!;
  if (w === 0) return;
  const x1 = curves[at + 2]!;
  const y1 = curves[at + 3]!;
  const x2 = curves[at + 5]!;
  const y2 = curves[at + 6]!;
  const wanted = cross(x0, y0, x1, y1, x2, y2) * shareOfTriangle(w);
  if (wanted === 0) return;
  const from = points.length;
  addInner(points, x0, y0, x1, y1, w, x2, y2, tolerance * tolerance, 0);
  let area = 0;
  for (let k = from; k < points.length; k += 2) {
    const isLast = k + 2 === points.length;
    const nextX = isLast ? x2 : points[k + 2]!;
    const nextY = isLast ? y2 : points[k + 3]!;
    area += cross(x0, y0, points[k]!, points[k + 1]!, nextX, nextY);
  }
  const more = wanted / area - 1;
  if (!(Math.abs(more) < 1)) return; // a curve that is straight but for rounding
  const dx = x2 - x0;
  const dy = y2 - y0;
  const share = more / (dx * dx + dy * dy);
  for (let k = from; k < points.length; k += 2) {
    const off = share * cross(x0, y0, x2, y2, points[k]!, points[k + 1]!);
    points[k]! -= off * dy;
    points[k + 1]! += off * dx;
  }
}

/**
 * The polygon of an outline. A curve has the same points from both sides, if it is the same and its
 * tolerance is.
 */
export function polygonOf(
  { curves, starts }: Outline,
  toleranceOf: (curve: number) => number,
): Rings {
  return Array.from(starts.subarray(1), (end, ring) => {
    const points: number[] = [];
    for (let k = starts[ring]!; k < end; ++k) addCurve(points, curves, 7 * k, toleranceOf(k));
    return new Float64Array(points);
  });
}

/** The outline whose curves are the sides of a polygon. */
export function outlineOf(rings: Rings): Outline {
  const curves: number[] = [];
  const starts = [0];
  for (const ring of rings) {
    let [x, y] = ring.subarray(-2) as unknown as [number, number];
    for (let k = 0; k < ring.length; k += 2) {
      const [nextX, nextY] = [ring[k]!, ring[k + 1]!];
      curves.push(x, y, (x + nextX) / 2, (y + nextY) / 2, 0, nextX, nextY);
      [x, y] = [nextX, nextY];
    }
    starts.push(curves.length / 7);
  }
  return { curves: Float64Array.from(curves), starts: Uint32Array.from(starts) };
}

/** A circle about the origin, of radius 1, as eight arcs. */
export function circle(): Outline {
  const one = Math.sqrt(0.5);
  const w = Math.sqrt((1 + one) / 2); // of an eighth of a turn
  const t = Math.SQRT2 - 1; // its tangent, of half the angle
  const corners = [1, 0, one, one, 0, 1, -one, one, -1, 0, -one, -one, 0, -1, one, -one];
  const tangents = [1, t, t, 1, -t, 1, -1, t, -1, -t, -t, -1, t, -1, 1, -t];
  const curves = Array.from({ length: 8 }, (_, k) => {
    const next = (2 * k + 2) % 16;
    return [
      corners[2 * k]!,
      corners[2 * k + 1]!,
      tangents[2 * k]!,
      tangents[2 * k + 1]!,
      w,
      corners[next]!,
      corners[next + 1]!,
    ];
  });
  return { curves: Float64Array.from(curves.flat()), starts: Uint32Array.of(0, 8) };
}
