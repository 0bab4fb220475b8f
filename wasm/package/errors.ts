/**
 * The kind of an error, for programs.
 * - "not-finite": a number is NaN or infinite, or what should be a number is something else
 * - "out-of-range": a magnitude above 1e100 (those below 1e-100 are taken as 0), or a count that
 *   is no whole number from 0 on
 * - "unknown-site": no site has this id
 * - "bad-length": not an array (of numbers, ids or items), an array of the wrong length, or one
 *   whose buffer is detached or has shrunk
 * - "bad-option": an option or accessor that is not documented
 * - "bad-bounds": bounds that are no box, or a region with an invalid ring or without an inside
 * - "bad-target": an area that no cell can have, or one for a site that cannot have a cell
 * - "no-convergence": weights for the given areas, or a largest circle, were not found
 * - "not-loaded": the WebAssembly is not available: it is used before `load`, its address does not
 *   answer, or compiling is forbidden here (a content security policy, an edge runtime)
 * - "disposed": the diagram has been disposed of
 * - "busy": a filter or maxDistance tried to change the diagram that was asking it, or the diagram
 *   has changed while an asynchronous call was under way
 * - "out-of-memory": memory ran out, or was never enough
 * - "corrupt-snapshot": bytes that are no snapshot of a diagram
 * - "too-large": more than 2^29 sites at once (one by one, memory runs out first)
 * - "broken": a call of this diagram was cut off in the middle, by a defect of the library (please
 *   report it) or by a stack overflow. The diagram takes no more calls except `dispose`; all others
 *   are unaffected. `toGeoJSON` also throws it if its polygons do not add up to the window, which
 *   is a defect, too; the diagram is then unchanged
 */
export type ErrorCode =
  | "not-finite"
  | "out-of-range"
  | "unknown-site"
  | "bad-length"
  | "bad-option"
  | "bad-bounds"
  | "bad-target"
  | "no-convergence"
  | "not-loaded"
  | "disposed"
  | "busy"
  | "out-of-memory"
  | "corrupt-snapshot"
  | "too-large"
  | "broken";

/**
 * Thrown by every call that cannot be carried out; the diagram is then as it was before the call,
 * unless `code` is "broken". `code` is for programs, `message` names the argument and its value.
 */
export class ApolloniusError extends Error {
  /** Always "ApolloniusError". */
  declare readonly name: "ApolloniusError";
  /** The kind of the error, for programs. */
  readonly code: ErrorCode;

  static {
    // on the prototype, where engines look for it when they write the first line of the stack
    Object.defineProperty(ApolloniusError.prototype, "name", {
      value: "ApolloniusError",
      writable: true,
      configurable: true,
    });
  }

  /** Made by the library; public for tests that imitate it. */
  constructor(code: ErrorCode, message: string, options?: { cause?: unknown }) {
    super(message, options);
    this.code = code;
  }
}
