// Natural neighbours of a point, and values that they interpolate at many points, for views of the
// plane and of the sphere.
import { allocated, checkedNumbers, checkOptions } from "../core/arguments.js";
import { Slices } from "../core/building.js";
import type { Inner } from "../core/inner.js";
import type { AnyNative } from "../core/native/module.js";
import { atPoint, ofItems } from "../core/space.js";
import { ApolloniusError } from "../errors.js";
import { numbersById } from "./by_id.js";
import { isWithin, type Limits, limitOf, limitsOf } from "./limits.js";
import type {
  AsyncInterpolationOptions,
  InterpolationOptions,
  MaxDistance,
  NaturalWeights,
  NumbersById,
} from "./types.js";

const kPoints = 1024; // points that are interpolated between two looks at the clock

/** The parts of a view that interpolation needs. */
export interface Asked<Native extends AnyNative> {
  /** How far the view's cells reach. */
  readonly limit: MaxDistance;
  /** Called again after each read of the caller's objects, as these may even dispose the view. */
  innerNow(): Inner<Native>;
  weights(native: Native, x: number, y: number, r: number): NaturalWeights;
  /** Returns a value for each point. */
  values(
    native: Native,
    known: ArrayLike<number>,
    points: ArrayLike<number>,
    r: number,
  ): Float64Array;
}

/** Returns the weight of the new sites. */
function weightOf({ native, space }: Inner, options: InterpolationOptions | undefined): number {
  const r = options?.r ?? 0;
  const error = space.error("options.r", 2, r, native);
  if (error) throw error;
  return r;
}

/**
 * Returns null if there are no sites, if the new cell would have no part in the window, or if the
 * point is beyond the reach of its cell.
 */
export function naturalWeights<Native extends AnyNative>(
  { limit, innerNow, weights }: Asked<Native>,
  x: number,
  y: number,
  options: InterpolationOptions | undefined,
): NaturalWeights | null {
  innerNow();
  checkOptions(options, "r");
  const inner = innerNow();
  const r = weightOf(inner, options);
  const found = atPoint(inner, x, y, (native) => weights(native, x, y, r));
  if (found.ids.length === 0) return null;
  if (limit === Infinity) return found;
  const most = limitOf(inner, limit, inner.native.find(x, y));
  return isWithin(inner.native, most, x, y) ? found : null;
}

export function interpolate<Native extends AnyNative>(
  asked: Asked<Native>,
  values: NumbersById,
  points: ArrayLike<number>,
  options: InterpolationOptions | undefined,
): Float64Array {
  const { native, space } = asked.innerNow();
  checkOptions(options, "r");
  const known = numbersById(native, "values", values, "bad-length");
  const field = new Field(asked, known, options);
  return field.at(checkedNumbers(space.points, points, 2));
}

/** Does `interpolate` in slices, with a turn of the event loop after each. */
export async function interpolateAsync<Native extends AnyNative>(
  asked: Asked<Native>,
  values: NumbersById,
  points: ArrayLike<number>,
  options: AsyncInterpolationOptions | undefined,
): Promise<Float64Array> {
  const { native, space } = asked.innerNow();
  checkOptions(options, "r", "signal", "onProgress");
  const slices = new Slices(options ?? {});
  // Copies, as the caller's arrays may change meanwhile.
  const known = Float64Array.from(numbersById(native, "values", values, "bad-length"));
  const field = new Field(asked, known, options);
  const all = Float64Array.from(checkedNumbers(space.points, points, 2));
  const results = allocated(() => new Float64Array(all.length / 2));
  for (let from = 0; from < results.length; from += kPoints) {
    if (slices.isOver) await slices.next(from / results.length);
    results.set(field.at(all.subarray(2 * from, 2 * (from + kPoints))), from);
  }
  await slices.next(1);
  return results;
}

/** A field that is given by values of sites. It is valid until the diagram changes. */
class Field<Native extends AnyNative> {
  readonly #asked: Asked<Native>;
  readonly #known: ArrayLike<number>;
  readonly #r: number;
  readonly #limits: Limits;
  readonly #revision: number;

  constructor(
    asked: Asked<Native>,
    known: ArrayLike<number>,
    options: InterpolationOptions | undefined,
  ) {
    const inner = asked.innerNow();
    this.#asked = asked;
    this.#known = known;
    this.#r = weightOf(inner, options);
    this.#limits = limitsOf(inner, asked.limit);
    this.#revision = inner.native.revision();
  }

  /** Returns the field at points. Throws "busy" if the diagram has changed. */
  at(points: ArrayLike<number>): Float64Array {
    const inner = this.#asked.innerNow();
    const { native } = inner;
    if (native.revision() !== this.#revision)
      throw new ApolloniusError("busy", "the diagram has changed meanwhile");
    let results: Float64Array;
    try {
      results = this.#asked.values(native, this.#known, points, this.#r);
    } catch (error) {
      throw ofItems(error, inner, points, 2);
    }
    const limits = this.#limits;
    if (limits === Infinity || native.size() === 0) return results;
    for (let k = 0; k < results.length; ++k) {
      const [x, y] = [points[2 * k]!, points[2 * k + 1]!];
      const most = typeof limits === "number" ? limits : limits[native.find(x, y)]!;
      if (!isWithin(native, most, x, y)) results[k] = NaN;
    }
    return results;
  }
}
