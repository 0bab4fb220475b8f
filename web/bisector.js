// Bisectors: pieces of hyperbola branches (or lines) as rational quadratic Bézier curves.
//
// The set |p - a| - ra = |p - b| - rb is, seen from the centre of the site with the larger weight (the pole), star-shaped: in
// the unit direction (c, s) it lies at the distance rho with 1/rho = qx·c + qy·s + qw, where for (x, y, r) = other minus pole
// and p = x² + y² - r² the form is (qx, qy, qw) = (2x, 2y, 2r) / p. A circular arc of directions is a rational quadratic
// curve, and (c, s, 1) -> (c, s, 1/rho) is linear: so every piece is exactly a rational quadratic curve with three control
// points and one weight. Parabolas, needed by the dual only, are quadratic curves without weights.
//
// Coordinates: the diagram's own, y upwards.

/**
 * A conic piece: end points (x0, y0) and (x2, y2), control point (x1, y1) with weight w >= 0, the end points' weights being 1.
 * @typedef {{ x0: number, y0: number, x1: number, y1: number, w: number, x2: number, y2: number }} Arc
 */

/** @returns {Arc} */
export const newArc = () => ({ x0: 0, y0: 0, x1: 0, y1: 0, w: 1, x2: 0, y2: 0 });

/** @param {Arc} arc */
function setSegment(arc, x0, y0, x2, y2) {
  arc.x0 = x0;
  arc.y0 = y0;
  arc.x1 = (x0 + x2) / 2;
  arc.y1 = (y0 + y2) / 2;
  arc.w = 1;
  arc.x2 = x2;
  arc.y2 = y2;
}

/**
 * The piece of the curve 1/rho = qx·c + qy·s + qw about the focus (fx, fy) between two of its points, which the focus sees at
 * an angle of at most pi. False if the form is not positive between them: then there is no finite piece.
 * @param {Arc} arc receives the piece
 */
export function setConic(arc, fx, fy, qx, qy, qw, x0, y0, x2, y2) {
  const rho0 = Math.hypot(x0 - fx, y0 - fy);
  const rho2 = Math.hypot(x2 - fx, y2 - fy);
  let mx = (x0 - fx) / rho0 + (x2 - fx) / rho2;
  let my = (y0 - fy) / rho0 + (y2 - fy) / rho2;
  const m = Math.hypot(mx, my); // 2 cos(half of the angle between the two directions)
  if (m > 1e-9) {
    mx /= m;
    my /= m;
  } else {
    // Opposite directions: the middle one is at right angles, where the curve is.
    mx = (y2 - fy) / rho2;
    my = (fx - x2) / rho2;
    const turn = Math.sign(qx * mx + qy * my);
    mx *= turn;
    my *= turn;
  }
  const w1 = qx * mx + qy * my + (qw * m) / 2;
  if (!(w1 > 0)) return false;
  arc.x0 = x0;
  arc.y0 = y0;
  arc.x1 = fx + mx / w1;
  arc.y1 = fy + my / w1;
  arc.w = w1 * Math.sqrt(rho0 * rho2);
  arc.x2 = x2;
  arc.y2 = y2;
  return arc.w < Infinity;
}

/**
 * The directions in which an unbounded edge leaves: the angles of its two ends, first and second, when one walks along the
 * whole bisector of a and b with a's cell on the left.
 * @returns {[number, number]} radians
 */
export function asymptotes(ax, ay, ar, bx, by, br) {
  const d = Math.hypot(bx - ax, by - ay);
  const phi = Math.atan2(by - ay, bx - ax);
  const alpha = Math.acos(Math.max(-1, Math.min(1, (ar - br) / d)));
  return [phi - alpha, phi + alpha];
}

/**
 * The Voronoi edge between the sites a and b (each as x, y, r), from its first end to its second with a's cell on the left.
 * An end is a point, or null for an unbounded end. What lies further than `far` from the pole is cut off.
 * @param {Arc} arc receives the edge
 * @param {{x: number, y: number} | null} first
 * @param {{x: number, y: number} | null} second
 * @param {boolean} [cutBounded] whether bounded ends beyond `far` are cut off too
 * @returns {boolean} whether anything is left
 */
export function setBisector(arc, ax, ay, ar, bx, by, br, first, second, far, cutBounded = true) {
  const leftIsPole = ar >= br;
  const px = leftIsPole ? ax : bx;
  const py = leftIsPole ? ay : by;
  const x = leftIsPole ? bx - ax : ax - bx;
  const y = leftIsPole ? by - ay : ay - by;
  const r = leftIsPole ? br - ar : ar - br; // <= 0
  const d = Math.hypot(x, y);
  const p = (d - r) * (d + r);
  if (!(p > 0)) return false; // one covers the other: they have no bisector

  let x0 = first ? first.x : 0;
  let y0 = first ? first.y : 0;
  let x2 = second ? second.x : 0;
  let y2 = second ? second.y : 0;
  const cut0 = !first || (cutBounded && Math.hypot(x0 - px, y0 - py) > far);
  const cut2 = !second || (cutBounded && Math.hypot(x2 - px, y2 - py) > far);
  if (cut0 || cut2) {
    // Angles relative to the direction of the other site; alpha is where the bisector reaches the distance `far`.
    const cosAlpha = (p / (2 * far) - r) / d;
    if (!(cosAlpha < 1)) return false;
    const alpha = Math.acos(cosAlpha);
    const turn = leftIsPole ? 1 : -1; // walking with a on the left turns counter-clockwise about a, clockwise about b
    const angle = (qx, qy) => Math.atan2(x * (qy - py) - y * (qx - px), x * (qx - px) + y * (qy - py));
    const t0 = first ? angle(x0, y0) : -turn * alpha;
    const t2 = second ? angle(x2, y2) : turn * alpha;
    const clamp = (t) => Math.max(-alpha, Math.min(alpha, t));
    const s0 = cut0 ? clamp(t0) : t0;
    const s2 = cut2 ? clamp(t2) : t2;
    if ((s2 - s0) * turn <= 0) return false; // all of it lies beyond `far`
    const rho = (t) => p / (2 * (d * Math.cos(t) + r));
    const phi = Math.atan2(y, x);
    if (cut0) {
      x0 = px + rho(s0) * Math.cos(phi + s0);
      y0 = py + rho(s0) * Math.sin(phi + s0);
    }
    if (cut2) {
      x2 = px + rho(s2) * Math.cos(phi + s2);
      y2 = py + rho(s2) * Math.sin(phi + s2);
    }
  }
  if (r === 0 || !setConic(arc, px, py, (2 * x) / p, (2 * y) / p, (2 * r) / p, x0, y0, x2, y2)) {
    setSegment(arc, x0, y0, x2, y2);
  }
  return true;
}

/**
 * The parabola |p - c| - R = n·(p - a) + ra from a to b: as far from the circle (c, R) as from the line with the unit normal n.
 * With c as origin, x along the line and y along n it is y = (x² - k²) / 2k: a quadratic Bézier curve.
 */
function setParabola(arc, { x: cx, y: cy, r: cr }, nx, ny, ax, ay, ar, bx, by) {
  const k = cr + nx * (cx - ax) + ny * (cy - ay) + ar;
  if (!(k > 0)) return;
  const xa = ny * (ax - cx) - nx * (ay - cy);
  const xb = ny * (bx - cx) - nx * (by - cy);
  const x1 = (xa + xb) / 2;
  const y1 = nx * (ax - cx) + ny * (ay - cy) + (xa / k) * (x1 - xa);
  arc.x1 = cx + ny * x1 + nx * y1;
  arc.y1 = cy - nx * x1 + ny * y1;
}

/**
 * The edge of the dual graph between the centres of a and b, as Appendix A of the paper draws it: the bisector of the two
 * Voronoi circles (centre and clearance) at the ends of the Voronoi edge, which passes through both centres; a parabola if
 * one of them is unbounded (a half-plane), a segment if both are.
 * @param {Arc} arc receives the edge
 * @param {{x: number, y: number, r: number} | null} first circle at the first end of the Voronoi edge
 * @param {{x: number, y: number, r: number} | null} second
 */
export function setDualEdge(arc, ax, ay, ar, bx, by, br, first, second) {
  setSegment(arc, ax, ay, bx, by);
  if (first && second) {
    const pole = first.r >= second.r ? first : second;
    const other = pole === first ? second : first;
    const x = other.x - pole.x;
    const y = other.y - pole.y;
    const r = other.r - pole.r;
    const d = Math.hypot(x, y);
    const p = (d - r) * (d + r);
    const size = Math.abs(pole.r) + Math.hypot(ax - pole.x, ay - pole.y);
    if (!(d > 1e-7 * size) || !(p > 1e-7 * d * d)) return; // an edge of length zero, up to rounding: stay straight
    setConic(arc, pole.x, pole.y, (2 * x) / p, (2 * y) / p, (2 * r) / p, ax, ay, bx, by) || setSegment(arc, ax, ay, bx, by);
  } else if (first || second) {
    const circle = first ?? second;
    const [before, after] = asymptotes(ax, ay, ar, bx, by, br);
    const theta = first ? after : before; // where the unbounded end leaves; the half-plane's inner normal is -direction
    setParabola(arc, circle, -Math.cos(theta), -Math.sin(theta), ax, ay, ar, bx, by);
  }
}
