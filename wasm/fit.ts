// `fitAreas`: the library's steps, one by one, and what is asked and told between them.
import {
  checkedCount,
  checkedNumbers,
  checkedTolerance,
  described,
  numberError,
} from "./arguments.js";
import type { NativeWindow } from "./drawing.js";
import { ApolloniusError } from "./errors.js";
import type { Fitting, NativeDiagram } from "./module.js";
import { checkOptions } from "./options.js";
import { ofElements } from "./status.js";
import type { FitOptions, FitProgress, FittedAreas } from "./types.js";

/** The weights are the diagram's then; null if stopped. */
export function fitAreas(
  native: NativeDiagram,
  window: NativeWindow,
  targets: ArrayLike<number>,
  options?: FitOptions | null,
): FittedAreas | null {
  checkOptions(options, "tolerance", "maxIterations", "start", "onIteration");
  const { maxIterations = 300, start = [], onIteration } = options ?? {};
  const tolerance = checkedTolerance(options?.tolerance, () => 1e-6);
  const most = checkedCount("maxIterations", maxIterations);
  if (onIteration !== undefined && typeof onIteration !== "function")
    throw new ApolloniusError(
      "bad-option",
      `onIteration is ${described(onIteration)}, expected a function`,
    );
  const fitting = begin(native, window, checkedNumbers("targets", targets, 1), start);
  try {
    let progress = { iterations: 0, error: fitting.error() };
    while (progress.error > tolerance) {
      if (progress.iterations === most) throw notReached(progress, "more are not allowed");
      try {
        fitting.step();
      } catch (error) {
        if (!(error instanceof ApolloniusError && error.code === "no-convergence")) throw error;
        throw notReached(progress, "no step comes closer");
      }
      progress = { iterations: progress.iterations + 1, error: fitting.error() };
      if (onIteration?.({ ...progress }) === false) return null;
    }
    const weights = fitting.weights();
    if (weights.length > 0) native.finishFit(fitting);
    return { ...progress, weights };
  } finally {
    fitting.delete();
  }
}

function begin(
  native: NativeDiagram,
  window: NativeWindow,
  targets: ArrayLike<number>,
  start: ArrayLike<number>,
): Fitting {
  const weights = checkedNumbers("start", start, 1);
  let fitting: Fitting;
  try {
    fitting = native.fitAreas(...window, targets, weights) as Fitting;
  } catch (error) {
    throw ofElements(error, "start", weights);
  }
  const id = fitting.badSite();
  if (id === -1) return fitting;
  fitting.delete();
  const target = targets[id] as number;
  throw new ApolloniusError(
    "bad-target",
    numberError(`targets[${id}]`, target)?.message ??
      (target > 0
        ? `the cell of site ${id} is empty with equal weights: its centre is another's, too, or ` +
          "outside the window"
        : `targets[${id}] is ${target}, expected a number above 0`),
  );
}

function notReached({ iterations, error }: FitProgress, why: string): ApolloniusError {
  return new ApolloniusError(
    "no-convergence",
    `after ${iterations} steps areas are off by up to ${error} of what they are to be; ${why}`,
  );
}
