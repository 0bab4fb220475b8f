// Drawing of outlines: conics as cubic Bezier curves, as src/geometry/draw/cubics.cpp draws them.
import { drawn, type DrawOptions, type PathContext } from "../core/path.js";
import { halved, length } from "../shapes/curves.js";
import { toleranceOf } from "../shapes/drawing.js";
import type { Outline } from "./outline.js";
import type { Frame } from "./rings.js";

/** The default tolerance is at most this share of a curve's size, and no tolerance is finer. */
const kShare = 3 * 2 ** -10;
const kFinestShare = 2 ** -36;

/** Draws an outline that is in a frame; null for nothing, whose path is null. */
export function drawOutline(
  outline: Outline | null,
  frame: Frame,
  usual: number, // the tolerance without one
  context: PathContext | null | undefined,
  options: DrawOptions | undefined,
): string | null | void {
  const given = toleranceOf(options);
  const path = drawn(context, options, (target) => {
    if (outline !== null) drawInto(target, outline, frame, given, usual);
  });
  return path === "" ? null : path;
}

function drawInto(
  target: PathContext,
  { curves, starts }: Outline,
  frame: Frame,
  given: number, // or 0
  usual: number,
): void {
  const x = (value: number) => frame.x + frame.scale * value;
  const y = (value: number) => frame.y + frame.scale * value;
  for (let ring = 0; ring + 1 < starts.length; ++ring) {
    const [from, to] = [starts[ring]!, starts[ring + 1]!];
    target.moveTo(x(curves[7 * from]!), y(curves[7 * from + 1]!));
    for (let k = from; k < to; ++k) {
      const [x0, y0, x1, y1, w, x2, y2] = curves.subarray(7 * k, 7 * k + 7);
      if (w !== 0) {
        const size = frame.scale * (length(x1! - x0!, y1! - y0!) + length(x2! - x1!, y2! - y1!));
        const allowed = Math.max(given || Math.min(usual, kShare * size), kFinestShare * size);
        addConic(target, allowed, x(x0!), y(y0!), x(x1!), y(y1!), w!, x(x2!), y(y2!));
      } else if (k + 1 < to) target.lineTo(x(x2!), y(y2!));
    }
    target.closePath();
  }
}

function addConic(
  target: PathContext,
  tolerance: number,
  x0: number,
  y0: number,
  x1: number,
  y1: number,
  w: number,
  x2: number,
  y2: number,
): void {
  const far = length(x1 - (x0 + x2) / 2, y1 - (y0 + y2) / 2);
  const whole = 1 + w;
  const z = (w - 1) / whole;
  if ((w / whole) * far <= tolerance) target.lineTo(x2, y2);
  else if (z * z * (0.02 + 0.054 * Math.max(0, z)) * far <= tolerance) {
    const share = (4 * w) / (3 * whole); // to the shoulder, as the conic
    target.bezierCurveTo(
      x0 + share * (x1 - x0),
      y0 + share * (y1 - y0),
      x2 + share * (x1 - x2),
      y2 + share * (y1 - y2),
      x2,
      y2,
    );
  } else {
    const { ax, ay, x, y, bx, by, w: half } = halved(x0, y0, x1, y1, w, x2, y2);
    addConic(target, tolerance, x0, y0, ax, ay, half, x, y);
    addConic(target, tolerance, x, y, bx, by, half, x2, y2);
  }
}
