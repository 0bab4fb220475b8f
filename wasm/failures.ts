// From the library's status integers to thrown errors.
import { numberError, throwElementError, unknownSite } from "./arguments.js";
import { ApolloniusError, type ErrorCode } from "./errors.js";
import type { Status } from "./native.js";

export const kUnknownSite: Status = 3;

// By status: the order of `Error` in src/apollonius/diagram.h. The message is the last resort; most
// failures know a better one.
const kFailures: readonly (readonly [ErrorCode, string] | null)[] = [
  null,
  ["not-finite", "a number is not finite"],
  ["out-of-range", "a number is outside the documented range"],
  ["unknown-site", "there is no such site"],
  ["bad-length", "lengths of arrays do not fit each other"],
  ["out-of-memory", "not enough memory"],
  ["too-large", "more sites than one diagram can hold"],
  ["bad-bounds", "the window is empty, inverted or out of range"],
  ["corrupt-snapshot", "bytes are no snapshot of a diagram, or damaged, or of another version"],
];

export function failure(status: Status): ApolloniusError {
  const known = kFailures[status];
  if (!known) throw new Error(`apollonius-diagram: unknown status ${status} from the wasm module`);
  return new ApolloniusError(known[0], known[1]);
}

export function outOfMemory(): ApolloniusError {
  return failure(5);
}

/** Throws unless the status is success. */
export function check(status: Status): void {
  if (status !== 0) throw failure(status);
}

/** `check` for calls about one site, whose id the message names. */
export function checkSite(status: Status, id: unknown): void {
  if (status === kUnknownSite) throw unknownSite(id);
  check(status);
}

/** Throws for a failed call with scalars, naming the first bad one. */
export function throwForNumbers(status: Status, x: unknown, y: unknown, r: unknown = 0): never {
  throw numberError("x", x) ?? numberError("y", y) ?? numberError("r", r) ?? failure(status);
}

/** Throws for a failed call with an array of numbers, naming the first bad element. */
export function throwForElements(status: Status, name: string, values: ArrayLike<number>): never {
  throwElementError(name, values);
  throw failure(status);
}

/**
 * Throws unless x, y and r are of type number; what number they may be is the library's to check.
 */
export function checkTypes(x: unknown, y: unknown, r: unknown = 0): void {
  if (typeof x !== "number" || typeof y !== "number" || typeof r !== "number")
    throwForNumbers(0, x, y, r);
}
