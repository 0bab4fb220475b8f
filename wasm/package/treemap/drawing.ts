// Drawing of outlines: conics as cubic Bezier curves.
import { drawn, type DrawOptions, type PathContext } from "../core/path.js";
import { halved } from "../shapes/curves.js";
import type { Outline } from "./outline.js";
import type { Frame } from "./rings.js";

/** A conic this near a parabola is within 1e-5 of its height of one cubic curve. */
const kNearParabola = 0.05;

/** Draws an outline that is in a frame; null for nothing. */
export function drawOutline(
  outline: Outline | null,
  frame: Frame,
  context: PathContext | null | undefined,
  options: DrawOptions | undefined,
): string | void {
  return drawn(context, options, (target) => {
    if (outline !== null) drawInto(target, outline, frame);
  });
}

function drawInto(target: PathContext, { curves, starts }: Outline, frame: Frame): void {
  const x = (value: number) => frame.x + frame.scale * value;
  const y = (value: number) => frame.y + frame.scale * value;
  for (let ring = 0; ring + 1 < starts.length; ++ring) {
    const [from, to] = [starts[ring]!, starts[ring + 1]!];
    target.moveTo(x(curves[7 * from]!), y(curves[7 * from + 1]!));
    for (let k = from; k < to; ++k) {
      const [x0, y0, x1, y1, w, x2, y2] = curves.subarray(7 * k, 7 * k + 7);
      if (w !== 0) addCubics(target, x(x0!), y(y0!), x(x1!), y(y1!), w!, x(x2!), y(y2!));
      else if (k + 1 < to) target.lineTo(x(x2!), y(y2!));
    }
    target.closePath();
  }
}

function addCubics(
  target: PathContext,
  x0: number,
  y0: number,
  x1: number,
  y1: number,
  w: number,
  x2: number,
  y2: number,
): void {
  const whole = 1 + w;
  if (Math.abs(w - 1) < kNearParabola) {
    const share = (4 * w) / (3 * whole); // to the shoulder, as the conic
    target.bezierCurveTo(
      x0 + share * (x1 - x0),
      y0 + share * (y1 - y0),
      x2 + share * (x1 - x2),
      y2 + share * (y1 - y2),
      x2,
      y2,
    );
    return;
  }
  const { ax, ay, x, y, bx, by, w: half } = halved(x0, y0, x1, y1, w, x2, y2);
  addCubics(target, x0, y0, ax, ay, half, x, y);
  addCubics(target, x, y, bx, by, half, x2, y2);
}
