// The default entry: carries its wasm as text and compiles it synchronously at the first use.
import text from "../build/wasm/apollonius.wasm";
import { isRunning, setModuleSource, start } from "./module.js";

export * from "./api.js";

function bytes(): Uint8Array<ArrayBuffer> {
  const decoded = new Uint8Array(text.length);
  for (let k = 0; k < decoded.length; ++k) decoded[k] = text.charCodeAt(k);
  return decoded;
}

setModuleSource(() => new WebAssembly.Module(bytes()));

/**
 * Compiles ahead of the first use and off the main thread. Optional: without it the first diagram compiles synchronously, a few
 * milliseconds.
 */
export async function load(): Promise<void> {
  if (!isRunning()) start(await WebAssembly.compile(bytes()));
}
