// Draws rational quadratic curves into anything with lineTo and bezierCurveTo, in pixels.

/** The largest distance, in pixels, between a drawn curve and the true one. */
export const kTolerance = 0.2;

// A cubic with the same end tangents and the same middle point is this far from a rational quadratic curve of weight w >= 1
// at most, in units of (w - 1) times the height of the control triangle. Measured (tests/web/bisector.test.mjs), not derived.
const kCubicError = 0.005;
const kMostHalvings = 12;

/**
 * Continues a path at (x0, y0) along the curve with control point (x1, y1), weight w, to (x2, y2).
 * @param {{ lineTo(x: number, y: number): void, bezierCurveTo(a: number, b: number, c: number, d: number, x: number, y: number): void }} path
 */
export function drawConic(path, x0, y0, x1, y1, w, x2, y2, depth = 0) {
  const height = Math.hypot(x1 - (x0 + x2) / 2, y1 - (y0 + y2) / 2);
  if (height * w < kTolerance * (1 + w)) {
    path.lineTo(x2, y2); // the curve's middle is height·w/(1+w) away from the segment's
    return;
  }
  if (kCubicError * Math.abs(w - 1) * height < kTolerance || depth >= kMostHalvings) {
    const t = (4 * w) / (3 * (1 + w));
    path.bezierCurveTo(x0 + t * (x1 - x0), y0 + t * (y1 - y0), x2 + t * (x1 - x2), y2 + t * (y1 - y2), x2, y2);
    return;
  }
  // Halve at the middle point; both halves have the same weight.
  const u = 1 / (1 + w);
  const ax = (x0 + w * x1) * u;
  const ay = (y0 + w * y1) * u;
  const bx = (x2 + w * x1) * u;
  const by = (y2 + w * y1) * u;
  const mx = (ax + bx) / 2;
  const my = (ay + by) / 2;
  const half = Math.sqrt((1 + w) / 2);
  drawConic(path, x0, y0, ax, ay, half, mx, my, depth + 1);
  drawConic(path, mx, my, bx, by, half, x2, y2, depth + 1);
}
