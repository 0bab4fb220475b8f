// All of the default entry: carries its wasm as text and compiles it synchronously at the first
// use.
import { swaps, text } from "../../build/wasm/apollonius.wasm";
import { bytesOf } from "./native/wasm_text.js";
import { notCompiled, isRunning, setModuleSource, start } from "./native/module.js";

export * from "./api.js";

const bytes = () => bytesOf(text, swaps);

setModuleSource(() => {
  try {
    return new WebAssembly.Module(bytes());
  } catch (cause) {
    throw notCompiled(cause);
  }
});

/**
 * Compiles ahead of the first use and off the main thread. Optional: without it the first diagram
 * compiles synchronously, a few milliseconds. Throws "not-loaded" where nothing may be compiled, as
 * that would.
 */
export async function load(): Promise<void> {
  if (isRunning()) return;
  try {
    start(await WebAssembly.compile(bytes()));
  } catch (cause) {
    throw notCompiled(cause);
  }
}
