// How far the cells of a view reach, as callers give it. Lists and functions are asked when a call
// needs an answer, before the call goes to the library.
import { checkNumber, described } from "../core/arguments.js";
import { filtering } from "../core/filters.js";
import type { Inner } from "../core/inner.js";
import type { AnyNative } from "../core/native/module.js";
import { atPoint } from "../core/space.js";
import { ApolloniusError } from "../errors.js";
import type { MaxDistance, ViewOptions } from "./types.js";

const kName = "options.maxDistance";

/** One for all sites, or by id, where Infinity stands at ids without a site. */
export type Limits = number | Float64Array;

/** Infinity, where cells end nowhere but at others. Of lists and functions, nothing is read. */
export function checkedLimit(options: ViewOptions | undefined): MaxDistance {
  const limit: unknown = options?.maxDistance;
  if (limit === undefined) return Infinity;
  const isAsked = typeof limit === "function" || (typeof limit === "object" && limit !== null);
  if (!isAsked && limit !== Infinity) checkNumber(kName, limit);
  return limit as MaxDistance;
}

function asked(limit: Exclude<MaxDistance, number>, id: number): number {
  const value: unknown =
    typeof limit === "function"
      ? limit(id)
      : "get" in limit && typeof limit.get === "function" // a Map of any realm
        ? limit.get(id)
        : (limit as ArrayLike<number>)[id];
  if (value === undefined && typeof limit !== "function")
    throw new ApolloniusError(
      "bad-option",
      `${kName} is ${described(limit)} that has none for site ${id}: add it there, or give a ` +
        "function of an id",
    );
  if (value !== Infinity) checkNumber(`${kName} of site ${id}`, value);
  return value as number;
}

/** How far the cell of a site reaches now. */
export function limitOf({ filters }: Inner, limit: MaxDistance, id: number): number {
  return typeof limit === "number" ? limit : filtering(filters, () => asked(limit, id));
}

/** How far all cells reach now; asked once a site. */
export function limitsOf({ native, filters }: Inner, limit: MaxDistance): Limits {
  if (typeof limit === "number") return limit;
  const ids = native.ids();
  const limits = new Float64Array(native.idLimit()).fill(Infinity);
  filtering(filters, () => {
    for (const id of ids) limits[id] = asked(limit, id);
  });
  return limits;
}

/** Is a site as near as that? Exact. */
export function isWithin(native: AnyNative, most: number, x: number, y: number): boolean {
  return most === Infinity || native.findWithin(x, y, most) !== -1;
}

/** Is a site the nearest one, and does its cell reach so far? */
export function contains(
  inner: Inner,
  limit: MaxDistance,
  id: number,
  x: number,
  y: number,
): boolean {
  const nearest = atPoint(inner, x, y, (native) => native.find(x, y));
  return nearest === id && isWithin(inner.native, limitOf(inner, limit, id), x, y);
}
