// The entry `apollonius-diagram/core`: carries its wasm as text, which is decoded and compiled at
// the first use.
import { swaps, text } from "../../build/wasm/core.wasm";
import { embed } from "./core/native/embedded.js";

export * from "./core/api.js";

const compiled = embed("core", text, swaps);

/**
 * Compiles the part ahead of its first use and off the main thread. Optional: without it the first
 * diagram compiles it synchronously, a few milliseconds. Throws "not-loaded" where compiling is
 * forbidden, as that would.
 */
export async function load(): Promise<void> {
  await compiled();
}
