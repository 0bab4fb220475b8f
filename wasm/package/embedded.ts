// All of the default entry: carries its wasm as text and compiles it synchronously at the first
// use.
import { swaps, text } from "../../build/wasm/apollonius.wasm";
import { notCompiled, isRunning, setModuleSource, start } from "./module.js";

export * from "./api.js";

function bytes(): Uint8Array<ArrayBuffer> {
  const byteOf = Uint8Array.from({ length: 256 }, (_, code) => code);
  for (let k = 0; k < swaps.length; k += 2) {
    const a = swaps[k] as number,
      b = swaps[k + 1] as number;
    byteOf[a] = b;
    byteOf[b] = a;
  }
  const decoded = new Uint8Array(text.length);
  for (let k = 0; k < decoded.length; ++k) decoded[k] = byteOf[text.charCodeAt(k)] as number;
  return decoded;
}

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
