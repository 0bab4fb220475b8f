// Boundaries of cells: rings of curves, as `cellCurves` gives them, and polygons of the same area.

/** Rings of curves x0, y0, x1, y1, w, x2, y2 (w = 0: a segment), and where each ring starts. */
export interface Outline {
  readonly curves: Float64Array;
  readonly starts: Uint32Array;
}

/** Rings x, y, …, not closed by their first point again; their insides are on their left. */
export type Rings = readonly Float64Array[];

/** Three control points and a weight: a rational quadratic Bezier curve. */
type Conic = [x0: number, y0: number, x1: number, y1: number, w: number, x2: number, y2: number];

const kDeepest = 16;

/** The two halves of a conic, which meet at its shoulder. */
function halvesOf([x0, y0, x1, y1, w, x2, y2]: Conic): [Conic, Conic] {
  const whole = 1 + w;
  const [ax, ay] = [(x0 + w * x1) / whole, (y0 + w * y1) / whole];
  const [bx, by] = [(x2 + w * x1) / whole, (y2 + w * y1) / whole];
  const [x, y] = [(ax + bx) / 2, (ay + by) / 2];
  const half = Math.sqrt(whole / 2);
  return [
    [x0, y0, ax, ay, half, x, y],
    [x, y, bx, by, half, x2, y2],
  ];
}

/** How far the shoulder of a conic is from the middle of its chord. */
function heightOf([x0, y0, x1, y1, w, x2, y2]: Conic): number {
  const [x, y] = [x1 - (x0 + x2) / 2, y1 - (y0 + y2) / 2];
  return (w / (1 + w)) * Math.sqrt(x * x + y * y);
}

/**
 * The area between a conic of this weight and its chord, as a share of the triangle of its control
 * points: the triangle of the shoulder, and twice as much of each half; 2/3 of a parabola, w = 1.
 */
function shareOfTriangle(w: number, depth = 0): number {
  if (depth === kDeepest) return 2 / 3;
  const half = Math.sqrt((1 + w) / 2);
  return w / (1 + w) + (w / ((1 + w) * (1 + w))) * shareOfTriangle(half, depth + 1);
}

/** Twice the signed area of a triangle. */
function cross(ax: number, ay: number, bx: number, by: number, cx: number, cy: number): number {
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}

/** Adds the points between the ends of a conic, so that chords are within the tolerance. */
function addInner(points: number[], conic: Conic, tolerance: number, depth: number): void {
  if (depth > 0 && (depth === kDeepest || !(heightOf(conic) > tolerance))) return;
  const [first, second] = halvesOf(conic);
  addInner(points, first, tolerance, depth + 1);
  points.push(second[0], second[1]);
  addInner(points, second, tolerance, depth + 1);
}

/**
 * The points of a conic but for its end. Those inside are moved away from the chord, or towards it,
 * in one proportion, so that the area between is the curve's.
 */
function addConic(points: number[], conic: Conic, tolerance: number): void {
  const [x0, y0, x1, y1, w, x2, y2] = conic;
  points.push(x0, y0);
  const wanted = cross(x0, y0, x1, y1, x2, y2) * shareOfTriangle(w);
  if (w === 0 || wanted === 0) return;
  const from = points.length;
  addInner(points, conic, tolerance, 0);
  let area = 0;
  for (let k = from - 2; k + 2 < points.length; k += 2)
    area += cross(x0, y0, points[k]!, points[k + 1]!, points[k + 2]!, points[k + 3]!);
  area += cross(x0, y0, points.at(-2)!, points.at(-1)!, x2, y2);
  const more = wanted / area - 1;
  if (!(Math.abs(more) < 1)) return; // of a curve that is straight but for rounding
  const [dx, dy] = [x2 - x0, y2 - y0];
  const square = dx * dx + dy * dy;
  for (let k = from; k < points.length; k += 2) {
    const off = (more * cross(x0, y0, x2, y2, points[k]!, points[k + 1]!)) / square;
    points[k]! -= off * dy;
    points[k + 1]! += off * dx;
  }
}

function conicAt(curves: Float64Array, k: number): Conic {
  return Array.from(curves.subarray(7 * k, 7 * k + 7)) as Conic;
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
    for (let k = starts[ring]!; k < end; ++k) addConic(points, conicAt(curves, k), toleranceOf(k));
    return Float64Array.from(points);
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
