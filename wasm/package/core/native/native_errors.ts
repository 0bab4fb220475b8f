// Turns the library's errors into exceptions that name the argument.
import type { MainModule } from "../../../../build/wasm/apollonius.mjs";
import { ApolloniusError, type ErrorCode } from "../../errors.js";
import { numberError, outOfMemory, throwFirst, unknownSite } from "../arguments.js";

type NativeErrors = MainModule["Error"]; // `Error` of src/apollonius/diagram.h

// These messages are the last resort; most callers make a better one.
const kFailures: Record<
  Exclude<keyof NativeErrors, "kNone" | "kOutOfMemory">,
  readonly [ErrorCode, string]
> = {
  kNotFinite: ["not-finite", "a number is not finite"],
  kOutOfRange: ["out-of-range", "a number is outside the documented range"],
  kUnknownSite: ["unknown-site", "there is no such site"],
  kBadLength: [
    "bad-length",
    "the length of an array does not fit another one, or the ids in use now",
  ],
  kTooLarge: ["too-large", "more sites than one diagram can hold"],
  kBadBounds: ["bad-bounds", "the window is empty, inverted or out of range"],
  kBadTarget: ["bad-target", "an area that no cell can have"],
  kNoConvergence: ["no-convergence", "sides of the window or cell nearly coincide"],
  kBusy: ["busy", "the diagram has changed meanwhile"],
  kBroken: ["broken", "the polygons do not add up to what they divide: please report it"],
  kCorruptSnapshot: [
    "corrupt-snapshot",
    "bytes are no snapshot of a diagram, or damaged, or of another version",
  ],
};

/** Returns the exception for the number of an error. */
export function failure(errors: NativeErrors, number: number): ApolloniusError {
  if (errors.kOutOfMemory.value === number) return outOfMemory();
  for (const name in kFailures) {
    if (errors[name as keyof typeof kFailures].value === number)
      return new ApolloniusError(...kFailures[name as keyof typeof kFailures]);
  }
  throw new Error(`apollonius-diagram: unknown error ${number} from the wasm module`);
}

function is(error: unknown, ...codes: ErrorCode[]): boolean {
  return error instanceof ApolloniusError && codes.includes(error.code);
}

/** Returns the error of a call about one site; its message names the id. */
export function ofSite(error: unknown, id: unknown): unknown {
  return is(error, "unknown-site") ? unknownSite(id) : error;
}

/** Is it the error for a number that is not finite or out of range? */
export function refusesNumbers(error: unknown): boolean {
  return is(error, "not-finite", "out-of-range");
}

/** Returns the error of a call with an array of numbers, or throws one that names the first bad. */
export function ofElements(error: unknown, name: string, values: ArrayLike<number>): unknown {
  if (refusesNumbers(error)) throwFirst(values, (value, k) => numberError(`${name}[${k}]`, value));
  return error;
}
