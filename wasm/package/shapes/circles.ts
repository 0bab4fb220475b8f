// Circles inside cells: the arguments of the calls, and all cells in slices.
import { allocated, checkNumber, checkOptions } from "../core/arguments.js";
import { Slices } from "../core/building.js";
import type { AsyncOptions } from "../core/types.js";
import { ApolloniusError } from "../errors.js";
import type { CellCircle, CellCircleOptions } from "./types.js";

const kMostAspect = 1000;
const kNumbers = 3; // of a circle
const kFewCells = 16;

/** Throws "bad-option", "not-finite", "out-of-range". */
export function checkedAspect(
  options: CellCircleOptions | undefined,
  ...others: readonly string[]
): number {
  checkOptions(options, "aspect", ...others);
  const aspect = options?.aspect ?? 1;
  checkNumber("options.aspect", aspect);
  if (aspect >= 1 / kMostAspect && aspect <= kMostAspect) return aspect;
  throw new ApolloniusError(
    "out-of-range",
    `options.aspect is ${aspect}, expected a number from 1/${kMostAspect} to ${kMostAspect}`,
  );
}

/** A circle, or null for NaN: none. */
export function circleOrNull<Circle extends Pick<CellCircle, "r">>(circle: Circle): Circle | null {
  return Number.isNaN(circle.r) ? null : circle;
}

/**
 * The circles of all cells, three numbers an id: those of ids from `first` to before `end` are
 * asked for at a time. `revisionNow` throws unless the view is there. Throws "busy" if the diagram
 * has changed meanwhile.
 */
export async function circlesInSlices(
  options: AsyncOptions | undefined,
  count: number,
  revisionNow: () => number,
  ask: (first: number, end: number) => Float64Array,
): Promise<Float64Array> {
  const slices = new Slices(options ?? {});
  const revision = revisionNow();
  const circles = allocated(() => new Float64Array(kNumbers * count));
  for (let first = 0; first < count; ) {
    if (slices.isOver) await slices.next(first / count);
    if (revisionNow() !== revision)
      throw new ApolloniusError("busy", "the diagram has changed meanwhile");
    const end = Math.min(first + kFewCells, count);
    circles.set(ask(first, end), kNumbers * first);
    first = end;
  }
  await slices.next(1);
  return circles;
}
