// A number for each site, as callers give them: an array by id, or the entries of a Map or of an
// object.
import {
  checkedNumbers,
  described,
  isArrayLike,
  isSiteId,
  numberError,
  unknownSite,
} from "../core/arguments.js";
import type { AnyNative } from "../core/native/module.js";
import { ApolloniusError, type ErrorCode } from "../errors.js";
import type { NumbersById } from "./types.js";

export function checkLength(
  native: AnyNative,
  name: string,
  values: ArrayLike<number>,
  hint: string,
): void {
  const expected = native.idLimit();
  if (values.length === expected) return;
  throw new ApolloniusError(
    "bad-length",
    `${name} has ${values.length} elements, expected ${expected}: one for each id that was ever ` +
      `used${hint}`,
  );
}

/** As an array by id. Throws "bad-length", "unknown-site", "not-finite", and `missing` for a site
 *  that has no entry. */
export function numbersById(
  native: AnyNative,
  name: string,
  given: NumbersById,
  missing: ErrorCode,
): ArrayLike<number> {
  if (isArrayLike(given) || typeof given !== "object" || given === null) {
    const values = checkedNumbers(name, given, 1);
    checkLength(native, name, values, "; a Map or an object by id takes those of the sites");
    return values;
  }
  const values = new Float64Array(native.idLimit());
  const isGiven = new Uint8Array(values.length);
  // A Map of any realm is what can be iterated.
  const entries = Symbol.iterator in given ? given : Object.entries(given);
  for (const entry of entries as Iterable<unknown>) {
    if (!Array.isArray(entry))
      throw new ApolloniusError(
        "bad-length",
        `${name} has ${described(entry)}, expected pairs of an id and a number`,
      );
    const [key, value] = entry as [unknown, number];
    const id = typeof key === "string" && String(Number(key)) === key ? Number(key) : key;
    if (!isSiteId(id) || !native.has(id)) throw unknownSite(id);
    if (typeof value !== "number") throw numberError(`${name}[${id}]`, value);
    values[id] = value;
    isGiven[id] = 1;
  }
  for (const id of native.ids())
    if (isGiven[id] === 0) throw new ApolloniusError(missing, `${name} has none for site ${id}`);
  return values;
}
