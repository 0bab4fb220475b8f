/** What went wrong, for programs. */
export type ErrorCode =
  | "not-finite"
  | "out-of-range"
  | "unknown-site"
  | "bad-length"
  | "bad-option"
  | "bad-bounds"
  | "disposed"
  | "out-of-memory"
  | "corrupt-snapshot"
  | "too-large";

/**
 * Thrown by every call that cannot be carried out; the diagram is then as it was before the call. `code` is for programs,
 * `message` names the argument and its value.
 */
export class ApolloniusError extends Error {
  override readonly name = "ApolloniusError";
  readonly code: ErrorCode;

  constructor(code: ErrorCode, message: string) {
    super(message);
    this.code = code;
  }
}
