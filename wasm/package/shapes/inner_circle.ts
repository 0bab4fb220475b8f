// The largest circle inside an outline of curves: a cell's, with the window's border and all its
// holes. (Cartographers call its centre the pole of inaccessibility.)
import { checkNumber, checkOptions } from "../core/arguments.js";
import { ApolloniusError } from "../errors.js";
import { halved, kOfCurve, length, sevenOf } from "./curves.js";
import type { CellCircleOptions } from "./types.js";
import { type Box, kGrain, Obstacles, type Place, widestPlace } from "./widest_place.js";

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
/** The numbers of a curve that are x; y comes after each. */
const kXs = [0, 2, 5];

/**
 * The largest circle inside rings of curves, the inside on the left of each: r is at least 0.999 of
 * what is possible, and the circle is inside but for rounding. With an `aspect`, the ellipse that
 * is as many times as wide as high: r is half its height.
 */
export function innerCircle(rings: Float64Array, aspect: number): Place {
  // With narrower x the ellipse is a circle, and conics are conics.
  const curves = rings.map((value, k) => (kXs.includes(k % kOfCurve) ? value / aspect : value));
  const box = boxOf(curves);
  const finest = kGrain * Math.max(...box.map(Math.abs));
  // With finer chords once more where the cell is thin.
  let slack = Math.max(finest, 2 ** -14 * Math.min(box[2] - box[0], box[3] - box[1]));
  let chords = chordsOf(curves, slack);
  // A point of the border is a circle, too: where no double is inside, the only one.
  let place: Place = { x: curves[0]!, y: curves[1]!, r: 0 };
  for (;;) {
    place = widestPlace(chords, box, place);
    if (chords.slack <= kSlack * place.r || slack === finest) break;
    slack = Math.max(finest, slack / 16);
    chords = chordsOf(curves, slack);
  }
  return { x: place.x * aspect, y: place.y, r: place.r };
}

/** The box of the control points, in which the curves are. */
export function boxOf(curves: Float64Array): Box {
  const box: [number, number, number, number] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let k = 0; k < curves.length; k += kOfCurve) {
    for (const at of kXs) {
      const [x, y] = [curves[k + at]!, curves[k + at + 1]!];
      box[0] = Math.min(box[0], x);
      box[1] = Math.min(box[1], y);
      box[2] = Math.max(box[2], x);
      box[3] = Math.max(box[3], y);
    }
  }
  return box;
}

/** Chords of the curves that are within `most` of them. */
function chordsOf(curves: Float64Array, most: number): Obstacles {
  const chords = new Obstacles();
  for (let k = 0; k < curves.length / kOfCurve; ++k) {
    const pieces = [sevenOf(curves, k)]; // to be done, the next one at the end
    while (pieces.length > 0) {
      const piece = pieces.pop()!;
      const [x0, y0, , , , x2, y2] = piece;
      const height = heightOf(...piece);
      if (height > most) {
        const { ax, ay, x, y, bx, by, w } = halved(...piece);
        pieces.push([x, y, bx, by, w, x2, y2], [x0, y0, ax, ay, w, x, y]);
      } else {
        chords.addSegment(x0, y0, x2, y2);
        chords.slack = Math.max(chords.slack, height);
      }
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
  return length(x1 - (x0 + x2) / 2, y1 - (y0 + y2) / 2);
}
