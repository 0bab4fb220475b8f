// All cells at once: each as a path of its own in a context, or as text that the library writes.
import { ApolloniusError } from "../errors.js";
import { checkOptions, described } from "../core/arguments.js";
import type { NativeShapes } from "../core/native/module.js";
import {
  checkedContext,
  checkedDigits,
  type DrawOptions,
  type PathContext,
  PathString,
  play,
} from "../core/path.js";
import { type NativeWindow, toleranceOf } from "./drawing.js";

// Commands in one portion: some 4000 cells, of which the library keeps edges for their neighbours.
const kPortion = 1 << 15;
const kMostDigits = 15;

/** Draws cell after cell, each as a new path, and calls `each` with its site once it is there. */
export function drawCells(
  context: PathContext & { beginPath?(): void },
  native: NativeShapes,
  windowNow: () => NativeWindow,
  each: (id: number) => void,
  options: DrawOptions | undefined,
): void {
  checkedContext(context);
  checkOptions(options, "tolerance", "digits");
  const tolerance = toleranceOf(options);
  if (typeof each !== "function")
    throw new ApolloniusError(
      "bad-option",
      `each is ${described(each)}, expected a function of an id, such as one that fills the path`,
    );
  for (let cursor = 0, isDone = false; !isDone; ) {
    const portion = native.drawCells(...windowNow(), tolerance, cursor, kPortion);
    const { commands, coordinates, ends } = portion;
    for (let k = 0, from = 0, xy = 0; k < ends.length; k += 2) {
      const to = ends[k + 1]!;
      context.beginPath?.();
      xy = play(context, commands, coordinates, xy, from, to);
      each(ends[k]!);
      from = to;
    }
    ({ cursor, isDone } = portion);
  }
}

/** Decimal places for which rounding moves nothing by more than an eighth of the tolerance. */
function digitsFor(tolerance: number): number {
  let digits = 0;
  for (let scale = 1; digits < kMostDigits && scale * tolerance < 4; scale *= 10) ++digits;
  return digits;
}

/**
 * By id, null for those without a cell in the window. With a number of more than 15 digits, they
 * are drawn one by one.
 */
export function cellPaths(
  native: NativeShapes,
  windowNow: () => NativeWindow,
  options: DrawOptions | undefined,
): (string | null)[] {
  checkOptions(options, "tolerance", "digits");
  const tolerance = toleranceOf(options);
  const given = checkedDigits(options?.digits);
  const window = windowNow();
  const [, , ...bounds] = window;
  const digits = given ?? digitsFor(tolerance || native.defaultTolerance(...bounds));
  const paths = new Array<string | null>(native.idLimit()).fill(null);
  const decoder = new TextDecoder();
  for (let cursor = 0, isDone = false; !isDone; ) {
    const portion = native.cellPaths(...window, tolerance, digits, cursor, kPortion);
    const { commands: bytes, ends } = portion;
    if (!portion.isDone && ends.length === 0)
      return oneByOne(native, window, tolerance, digits, paths.fill(null));
    const text = decoder.decode(bytes);
    for (let k = 0, from = 0; k < ends.length; k += 2) {
      const to = ends[k + 1]!;
      paths[ends[k]!] = text.slice(from, to);
      from = to;
    }
    ({ cursor, isDone } = portion);
  }
  return paths;
}

function oneByOne(
  native: NativeShapes,
  window: NativeWindow,
  tolerance: number,
  digits: number,
  paths: (string | null)[],
): (string | null)[] {
  for (const id of native.ids()) {
    const { commands, coordinates } = native.drawCell(...window, id, tolerance);
    const text = new PathString(digits);
    play(text, commands, coordinates);
    paths[id] = text.toString() || null;
  }
  return paths;
}
