// Natural neighbours of one place, and values interpolated by them at many.
import { allocated, checkedNumbers, checkNumber, checkOptions } from "../core/arguments.js";
import { Slices } from "../core/building.js";
import type { NativeShapes } from "../core/native/module.js";
import { ofElements } from "../core/native/native_errors.js";
import { atSite, plane } from "../core/space.js";
import { ApolloniusError } from "../errors.js";
import { numbersById } from "./by_id.js";
import type { NativeWindow } from "./drawing.js";
import type {
  AsyncInterpolationOptions,
  InterpolationOptions,
  NaturalWeights,
  NumbersById,
} from "./types.js";

const kPoints = 1024; // interpolated between two looks at the clock

/** null without sites, or if the new cell is outside of the window. */
export function naturalWeights(
  native: NativeShapes,
  window: NativeWindow,
  x: number,
  y: number,
  r: number,
): NaturalWeights | null {
  const { ids, weights } = atSite({ native, space: plane }, x, y, r, () =>
    native.naturalWeights(...window, x, y, r),
  );
  return ids.length === 0 ? null : { ids, weights };
}

export function interpolate(
  native: NativeShapes,
  windowNow: () => NativeWindow,
  values: NumbersById,
  xy: ArrayLike<number>,
  options: InterpolationOptions | undefined,
): Float64Array {
  checkOptions(options, "r");
  const known = numbersById(native, "values", values, "bad-length");
  const field = new Field(native, windowNow, known, options);
  return field.at(checkedNumbers("xy", xy, 2));
}

/** The same, with a turn of the event loop between some thousand points. */
export async function interpolateAsync(
  native: NativeShapes,
  windowNow: () => NativeWindow,
  values: NumbersById,
  xy: ArrayLike<number>,
  options: AsyncInterpolationOptions | undefined,
): Promise<Float64Array> {
  checkOptions(options, "r", "signal", "onProgress");
  const slices = new Slices(options ?? {});
  // Copies, as the caller's arrays may change meanwhile.
  const known = Float64Array.from(numbersById(native, "values", values, "bad-length"));
  const field = new Field(native, windowNow, known, options);
  const points = Float64Array.from(checkedNumbers("xy", xy, 2));
  const results = allocated(() => new Float64Array(points.length / 2));
  for (let from = 0; from < results.length; from += kPoints) {
    if (slices.isOver) await slices.next(from / results.length);
    results.set(field.at(points.subarray(2 * from, 2 * (from + kPoints))), from);
  }
  await slices.next(1);
  return results;
}

/** Values by id, of a diagram as long as that stays as it is. */
class Field {
  readonly #native: NativeShapes;
  readonly #windowNow: () => NativeWindow;
  readonly #values: ArrayLike<number>;
  readonly #r: number;
  readonly #revision: number;

  constructor(
    native: NativeShapes,
    windowNow: () => NativeWindow,
    values: ArrayLike<number>,
    options: InterpolationOptions | undefined,
  ) {
    this.#native = native;
    this.#windowNow = windowNow;
    this.#r = options?.r ?? 0;
    checkNumber("options.r", this.#r);
    this.#values = values;
    this.#revision = native.revision();
  }

  /** Throws "busy" if the diagram has changed. */
  at(points: ArrayLike<number>): Float64Array {
    const window = this.#windowNow();
    if (this.#native.revision() !== this.#revision)
      throw new ApolloniusError("busy", "the diagram has changed meanwhile");
    try {
      return this.#native.interpolate(...window, this.#values, points, this.#r);
    } catch (error) {
      throw ofElements(error, "xy", points);
    }
  }
}
