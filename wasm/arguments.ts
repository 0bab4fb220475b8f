// Argument checks, and the words for what is wrong with an argument. The library itself checks numbers (once, at its own door);
// this file checks what only JavaScript can get wrong, and finds the culprit after the library has said no.
import { ApolloniusError } from "./errors.js";
import { kNoSite } from "./native.js";

// The documented range of magnitudes: kSmallestMagnitude and kLargestMagnitude of src/apollonius.h.
const kSmallestMagnitude = 1e-100;
const kLargestMagnitude = 1e100;

function described(value: unknown): string {
  if (typeof value === "string") return `the string ${JSON.stringify(value)}`;
  if (typeof value === "bigint") return `the bigint ${value}n`;
  if (typeof value === "object" && value !== null) return Array.isArray(value) ? "an array" : "an object";
  if (typeof value === "function") return "a function";
  return String(value);
}

/** The error that a value deserves as coordinate or weight, or null if it is fine. */
export function numberError(name: string, value: unknown): ApolloniusError | null {
  if (typeof value !== "number" || !Number.isFinite(value)) {
    return new ApolloniusError("not-finite", `${name} is ${described(value)}, expected a finite number`);
  }
  const magnitude = Math.abs(value);
  if (magnitude !== 0 && (magnitude < kSmallestMagnitude || magnitude > kLargestMagnitude)) {
    return new ApolloniusError("out-of-range", `${name} is ${value}, expected 0 or a magnitude from 1e-100 to 1e100`);
  }
  return null;
}

/** Throws for the first element of an array that is not acceptable. */
export function throwElementError(name: string, values: ArrayLike<number>): void {
  for (let k = 0; k < values.length; ++k) {
    const error = numberError(`${name}[${k}]`, values[k]);
    if (error) throw error;
  }
}

export function isSiteId(id: unknown): id is number {
  return typeof id === "number" && id >>> 0 === id && id !== kNoSite;
}

export function unknownSite(id: unknown): ApolloniusError {
  return new ApolloniusError("unknown-site", `site ${typeof id === "number" ? id : described(id)} does not exist`);
}

function isArrayLike(values: unknown): values is ArrayLike<unknown> {
  return typeof values === "object" && values !== null && Number.isSafeInteger((values as ArrayLike<unknown>).length) &&
    (values as ArrayLike<unknown>).length >= 0;
}

function isTypedArray(values: object): boolean {
  return ArrayBuffer.isView(values) && !(values instanceof DataView);
}

/**
 * Numbers that can be copied to the heap in one go: typed arrays as they are, anything else element by element, so that
 * strings and nulls are refused and not turned into numbers.
 */
export function checkedNumbers(name: string, values: unknown, multipleOf: number): ArrayLike<number> {
  if (!isArrayLike(values)) {
    throw new ApolloniusError("bad-length", `${name} is ${described(values)}, expected an array of numbers`);
  }
  if (values.length % multipleOf !== 0) {
    throw new ApolloniusError("bad-length", `expected a multiple of ${multipleOf} values in ${name}, got ${values.length}`);
  }
  const isBigInts = values instanceof BigInt64Array || values instanceof BigUint64Array;
  if (isTypedArray(values) && !isBigInts) return values as ArrayLike<number>;
  const numbers = new Float64Array(values.length);
  for (let k = 0; k < numbers.length; ++k) {
    const value = values[k];
    if (typeof value !== "number") throw numberError(`${name}[${k}]`, value) as ApolloniusError;
    numbers[k] = value;
  }
  return numbers;
}

/** Site ids for the heap; what cannot be an id becomes kNoSite, which no site has. */
export function checkedIds(name: string, ids: unknown): Uint32Array {
  if (ids instanceof Uint32Array) return ids;
  if (!isArrayLike(ids)) throw new ApolloniusError("bad-length", `${name} is ${described(ids)}, expected an array of site ids`);
  return Uint32Array.from({ length: ids.length }, (_, k) => (isSiteId(ids[k]) ? (ids[k] as number) : kNoSite));
}

/** A window [xmin, ymin, xmax, ymax] with xmin < xmax and ymin < ymax; throws "bad-bounds". */
export function checkedBounds(bounds: unknown): [number, number, number, number] {
  if (!isArrayLike(bounds) || bounds.length !== 4) {
    throw new ApolloniusError("bad-bounds", `bounds is ${described(bounds)}, expected [xmin, ymin, xmax, ymax]`);
  }
  const names = ["xmin", "ymin", "xmax", "ymax"] as const;
  const [xmin, ymin, xmax, ymax] = names.map((name, k) => {
    const error = numberError(`${name} of bounds`, bounds[k]);
    if (error) throw new ApolloniusError("bad-bounds", error.message);
    return bounds[k] as number;
  }) as [number, number, number, number];
  if (!(xmin < xmax && ymin < ymax)) {
    throw new ApolloniusError("bad-bounds", `bounds are [${xmin}, ${ymin}, ${xmax}, ${ymax}], expected xmin < xmax and ymin < ymax`);
  }
  return [xmin, ymin, xmax, ymax];
}

/** A positive number for which there is a default; throws "not-finite" or "out-of-range". */
export function checkedTolerance(tolerance: unknown, usual: () => number): number {
  if (tolerance === undefined) return usual();
  if (typeof tolerance !== "number" || !Number.isFinite(tolerance)) throw numberError("tolerance", tolerance) as ApolloniusError;
  if (!(tolerance > 0)) throw new ApolloniusError("out-of-range", `tolerance is ${tolerance}, expected a number above 0`);
  return tolerance;
}
