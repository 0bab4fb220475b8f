// The largest circle inside an outline of curves: a cell's, with the window's border and all its
// holes. (Cartographers call its centre the pole of inaccessibility.)
import { checkNumber, checkOptions } from "../core/arguments.js";
import { ApolloniusError } from "../errors.js";
import { kOfCurve } from "./curves.js";
import type { CellCircleOptions } from "./types.js";
import { type Box, length, Obstacles, type Place, widestPlace } from "./widest_place.js";

const kMostAspect = 1000;

/** Throws "bad-option", "not-finite", "out-of-range". */
export function checkedAspect(options: CellCircleOptions | undefined): number {
  checkOptions(options, "aspect");
  const aspect = options?.aspect ?? 1;
  checkNumber("options.aspect", aspect);
  if (aspect >= 1 / kMostAspect && aspect <= kMostAspect) return aspect;
  throw new ApolloniusError(
    "out-of-range",
    `options.aspect is ${aspect}, expected a number from 1/${kMostAspect} to ${kMostAspect}`,
  );
}

/** How far chords may be from curves, as a share of the circle's radius. */
const kSlack = 2 ** -12;

/**
 * With rings of curves around it; r is at least 0.999 of what is possible, and the circle is inside
 * but for rounding. With an `aspect`, the ellipse that is as many times as wide as high: r is half
 * its height.
 */
export function innerCircle(rings: ArrayLike<number>, aspect: number): Place {
  const [frame, curves, [xmin, ymin, xmax, ymax]] = frameOf(rings, aspect);
  // Curves are roughly known at first, and better and better where that matters.
  let slack = 2 ** -10 * Math.min(xmax - xmin, ymax - ymin);
  let chords = chordsOf(curves, slack);
  let box: Box = [xmin, ymin, xmax, ymax];
  // A point of the border is a circle, too: where no double is inside, the only one.
  let place: Place = { x: curves[0]!, y: curves[1]!, r: 0 };
  for (;;) {
    const { best, rest } = widestPlace(
      chords,
      box,
      (x, y, nearest) => (chords.surround(x, y) ? null : nearest),
      place,
    );
    [place, box] = [best ?? place, rest];
    if (chords.slack <= kSlack * place.r) break;
    slack /= 16;
    const finer = chordsOf(curves, slack);
    if (finer.count === chords.count) break;
    chords = finer;
  }
  return { ...frame.from(place.x, place.y), r: place.r };
}

/**
 * Coordinates in which an ellipse of this aspect is a circle (conics remain conics), and which are
 * turned where the outline is so thin that it is best looked at lengthwise. With the curves in
 * them, and their box.
 */
function frameOf(rings: ArrayLike<number>, aspect: number): readonly [Frame, Float64Array, Box] {
  const upright = new Frame(rings[0]!, rings[1]!, aspect, 1, 0);
  const curves = upright.curvesInto(rings);
  const box = boxOf(curves);
  // Along the way to what is farthest from what is farthest from the first point.
  let [far, other] = [0, 0];
  for (let round = 0; round < 2; ++round) {
    [other, far] = [far, other];
    let most = -1;
    for (let k = 0; k < curves.length; k += kOfCurve) {
      const away = length(curves[k]! - curves[other]!, curves[k + 1]! - curves[other + 1]!);
      if (away > most) [most, far] = [away, k];
    }
  }
  const dx = curves[far]! - curves[other]!;
  const dy = curves[far + 1]! - curves[other + 1]!;
  const whole = length(dx, dy);
  if (whole === 0) return [upright, curves, box];
  const turned = new Frame(rings[0]!, rings[1]!, aspect, dx / whole, dy / whole);
  const turnedCurves = turned.curvesInto(rings);
  const turnedBox = boxOf(turnedCurves);
  return areaOf(turnedBox) < areaOf(box) / 2
    ? [turned, turnedCurves, turnedBox]
    : [upright, curves, box];
}

/** Moved to (x, y), with narrower x, then turned by the angle of this cosine and sine. */
class Frame {
  constructor(
    readonly x: number,
    readonly y: number,
    readonly aspect: number,
    readonly cosine: number,
    readonly sine: number,
  ) {}

  curvesInto(rings: ArrayLike<number>): Float64Array {
    const curves = Float64Array.from(rings);
    for (let k = 0; k < curves.length; k += kOfCurve) {
      for (const at of [k, k + 2, k + 5]) {
        const [x, y] = [(curves[at]! - this.x) / this.aspect, curves[at + 1]! - this.y];
        curves[at] = this.cosine * x + this.sine * y;
        curves[at + 1] = this.cosine * y - this.sine * x;
      }
    }
    return curves;
  }

  from(x: number, y: number): { x: number; y: number } {
    return {
      x: this.x + this.aspect * (this.cosine * x - this.sine * y),
      y: this.y + (this.sine * x + this.cosine * y),
    };
  }
}

function areaOf([xmin, ymin, xmax, ymax]: Box): number {
  return (xmax - xmin) * (ymax - ymin);
}

/** The box of the control points, in which the curves are. */
export function boxOf(curves: Float64Array): Box {
  const box: [number, number, number, number] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let k = 0; k < curves.length; k += kOfCurve) {
    for (const at of [k, k + 2, k + 5]) {
      const [x, y] = [curves[at]!, curves[at + 1]!];
      box[0] = Math.min(box[0], x);
      box[1] = Math.min(box[1], y);
      box[2] = Math.max(box[2], x);
      box[3] = Math.max(box[3], y);
    }
  }
  return box;
}

/** Chords of the curves that are within `most` of them, as far as doubles can tell. */
function chordsOf(curves: Float64Array, most: number): Obstacles {
  const chords = new Obstacles();
  const pieces: number[] = []; // to be done, the next one at the end
  for (let k = 0; k < curves.length; k += kOfCurve) {
    for (let at = 0; at < kOfCurve; ++at) pieces.push(curves[k + at]!);
    while (pieces.length > 0) {
      const [x0, y0, x1, y1, w, x2, y2] = pieces.splice(-kOfCurve) as [
        number,
        number,
        number,
        number,
        number,
        number,
        number,
      ];
      // Both halves of the control polygon, and the middle of the arc.
      const [u, v] = [1 / (1 + w), w / (1 + w)];
      const [ax, ay, bx, by] = [u * x0 + v * x1, u * y0 + v * y1, u * x2 + v * x1, u * y2 + v * y1];
      const [x, y] = [(ax + bx) / 2, (ay + by) / 2];
      const isSplit = (x !== x0 || y !== y0) && (x !== x2 || y !== y2);
      const height = heightOf(x0, y0, x1, y1, w, x2, y2);
      if (!isSplit || height <= most) {
        chords.addSegment(x0, y0, x2, y2);
        if (isSplit) chords.slack = Math.max(chords.slack, height);
        continue;
      }
      const half = Math.sqrt((1 + w) / 2);
      pieces.push(x, y, bx, by, half, x2, y2, x0, y0, ax, ay, half, x, y);
    }
  }
  return chords;
}

/** How far a curve is at most from its chord, and the chord from the curve. */
function heightOf(
  x0: number,
  y0: number,
  x1: number,
  y1: number,
  w: number,
  x2: number,
  y2: number,
): number {
  if (w === 0) return 0;
  const [dx, dy] = [x2 - x0, y2 - y0];
  const [px, py] = [x1 - x0, y1 - y0];
  const square = dx * dx + dy * dy;
  const along = px * dx + py * dy;
  // The middle of the arc has the largest distance from the chord's line. Where the control point
  // is beyond an end of the chord, the curve can be, too.
  if (along >= 0 && along <= square && square > 0)
    return ((w / (1 + w)) * Math.abs(dx * py - dy * px)) / Math.sqrt(square);
  const [mx, my] = [x1 - (x0 + x2) / 2, y1 - (y0 + y2) / 2];
  return Math.sqrt(mx * mx + my * my);
}
