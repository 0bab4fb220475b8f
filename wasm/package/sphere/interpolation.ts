// Values interpolated by natural neighbours on the sphere.
import { checkedNumbers, checkOptions } from "../core/arguments.js";
import type { Inner } from "../core/inner.js";
import type { NativeSphericalDiagram } from "../core/native/module.js";
import { ofItems } from "../core/space.js";
import { numbersById } from "../shapes/by_id.js";
import type { InterpolationOptions, NumbersById } from "../shapes/types.js";

/** `innerNow` is asked again after each look at the caller's objects, which can do anything. */
export function interpolate(
  innerNow: () => Inner<NativeSphericalDiagram>,
  values: NumbersById,
  lonLat: ArrayLike<number>,
  options: InterpolationOptions | undefined,
): Float64Array {
  const known = numbersById(innerNow().native, "values", values, "bad-length");
  checkOptions(options, "r");
  const points = checkedNumbers("lonLat", lonLat, 2);
  const r = options?.r ?? 0;
  const inner = innerNow();
  const error = inner.space.error("options.r", 2, r, inner.native);
  if (error) throw error;
  try {
    return inner.native.interpolate(known, points, r);
  } catch (error) {
    throw ofItems(error, inner, points, 2);
  }
}
