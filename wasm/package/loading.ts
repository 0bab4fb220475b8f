// The errors of a module that cannot be loaded.
import { ApolloniusError } from "./errors.js";

export function notLoaded(message: string, cause?: unknown): ApolloniusError {
  return new ApolloniusError("not-loaded", message, { cause });
}

/** What an engine says when it does not compile or start a module. */
export function notCompiled(cause: unknown): unknown {
  if (cause instanceof RangeError) return cause; // the end of the stack
  const why = cause instanceof Error ? cause.message : String(cause);
  return notLoaded(
    `WebAssembly cannot be compiled here (${why}). A content security policy has to have ` +
      "script-src 'wasm-unsafe-eval'; where nothing may be compiled, as on some servers at the " +
      "edge, import the .wasm and give that module to load() of apollonius-diagram/wasm",
    cause,
  );
}
