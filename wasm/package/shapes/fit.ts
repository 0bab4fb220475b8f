// `fitAreas`: the library's steps, one by one, with progress and stopping between steps.
import {
  checkedChoice,
  checkedCount,
  checkedNumbers,
  checkedTolerance,
  checkOptions,
  described,
  numberError,
  taken,
} from "../core/arguments.js";
import { Slices } from "../core/building.js";
import type { Fitting, NativeShapes } from "../core/native/module.js";
import { ofElements } from "../core/native/native_errors.js";
import { ApolloniusError } from "../errors.js";
import { checkLength, numbersById } from "./by_id.js";
import type { NativeWindow } from "./drawing.js";
import type {
  AreaTargets,
  AsyncFitOptions,
  FitOptions,
  FitProgress,
  FittedAreas,
} from "./types.js";

const kOptions = ["tolerance", "maxIterations", "strict", "start", "onIteration"];

/** Finds the weights and gives them to the diagram. */
export function fitAreas(
  native: NativeShapes,
  windowNow: () => NativeWindow,
  targets: AreaTargets,
  options: FitOptions | undefined,
): FittedAreas {
  checkOptions(options, ...kOptions);
  const search = new Search(native, windowNow, targets, options);
  try {
    while (search.advance());
    return search.finish();
  } finally {
    search.end();
  }
}

/** Does `fitAreas` with turns of the event loop between steps. */
export async function fitAreasAsync(
  native: NativeShapes,
  windowNow: () => NativeWindow,
  targets: AreaTargets,
  options: AsyncFitOptions | undefined,
): Promise<FittedAreas> {
  checkOptions(options, ...kOptions, "signal", "onProgress");
  const { signal, onProgress } = options ?? {};
  const slices = new Slices({ signal, onProgress });
  const search = new Search(native, windowNow, targets, options);
  try {
    do {
      if (slices.isOver) await slices.next(search.share());
    } while (search.advance());
    onProgress?.(1);
    slices.expectNoAbort();
    return search.finish();
  } finally {
    search.end();
  }
}

/** The search for weights, step by step, in a diagram of its own. */
class Search {
  readonly #native: NativeShapes;
  readonly #tolerance: number;
  readonly #most: number;
  readonly #isStrict: boolean;
  readonly #onIteration: FitOptions["onIteration"];
  readonly #fitting: Fitting;
  #progress: FitProgress;
  readonly #firstError: number;
  #share = 0;
  #reason: string | undefined;

  constructor(
    native: NativeShapes,
    windowNow: () => NativeWindow,
    targets: AreaTargets,
    options: FitOptions | undefined,
  ) {
    const { maxIterations = 300, start = [], onIteration } = options ?? {};
    this.#native = native;
    this.#tolerance = checkedTolerance(options?.tolerance, () => 1e-6);
    this.#most = checkedCount("maxIterations", maxIterations);
    this.#isStrict = checkedChoice("options.strict", options?.strict, [false, true]);
    if (onIteration !== undefined && typeof onIteration !== "function")
      throw new ApolloniusError(
        "bad-option",
        `onIteration is ${described(onIteration)}, expected a function`,
      );
    this.#onIteration = onIteration;
    this.#fitting = begin(native, windowNow, targets, start);
    this.#firstError = this.#fitting.error();
    this.#progress = { iterations: 0, error: this.#firstError };
  }

  /** Does one step; returns false if none is left to do. */
  advance(): boolean {
    const { iterations, error } = this.#progress;
    if (!(error > this.#tolerance)) return false;
    if (iterations === this.#most) throw this.#notReached("more are not allowed");
    let next: number;
    try {
      next = this.#fitting.step();
    } catch (failure) {
      if (!(failure instanceof ApolloniusError && failure.code === "no-convergence")) throw failure;
      const isAtTheEnd = this.#fitting.isAtTheEndOfDoubles();
      const why = isAtTheEnd
        ? "the last places of weights and vertices do not allow less"
        : "no step comes closer";
      if (!isAtTheEnd || this.#isStrict) throw this.#notReached(why);
      this.#reason = why;
      return false;
    }
    this.#progress = { iterations: iterations + 1, error: next };
    this.#onIteration?.({ ...this.#progress });
    return true;
  }

  /**
   * Returns the share that is done, from 0 to 1, which never falls. It is measured in orders of
   * magnitude between the first error and the tolerance.
   */
  share(): number {
    const way = Math.log(this.#firstError / this.#tolerance);
    const done = Math.log(this.#firstError / this.#progress.error);
    if (done > this.#share * way) this.#share = Math.min(done / way, 1);
    return this.#share;
  }

  /** Gives the weights to the diagram. */
  finish(): FittedAreas {
    const weights = this.#fitting.weights();
    if (weights.length > 0) this.#native.finishFit(this.#fitting);
    const reason = this.#reason;
    return reason === undefined
      ? { ...this.#progress, converged: true, weights }
      : { ...this.#progress, converged: false, reason, weights };
  }

  end(): void {
    this.#fitting.delete();
  }

  #notReached(why: string): ApolloniusError {
    const { iterations, error } = this.#progress;
    return new ApolloniusError(
      "no-convergence",
      `after ${iterations} steps areas are off by up to ${error} of what they are to be, more ` +
        `than the tolerance of ${this.#tolerance}; ${why}`,
    );
  }
}

function begin(
  native: NativeShapes,
  windowNow: () => NativeWindow,
  given: AreaTargets,
  start: ArrayLike<number>,
): Fitting {
  windowNow(); // throws for cells that do not fill it
  const targets = numbersById(native, "targets", given, "bad-target");
  const weights = checkedNumbers("start", start, 1);
  if (weights.length > 0) checkLength(native, "start", weights, "");
  let fitting: Fitting;
  try {
    fitting = native.fitAreas(...windowNow(), targets, weights) as Fitting;
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
      (taken(target) > 0
        ? `the cell of site ${id} is empty with equal weights: its centre is another's, too, or ` +
          "outside the window"
        : `targets[${id}] is ${target}, expected a number above 0`),
  );
}
