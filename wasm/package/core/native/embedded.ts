// Parts that a bundle carries as text (asString in tools/build.mjs).
import { isRunning, notCompiled, type Part, setSource, start } from "./module.js";

/**
 * Lets the first use of a part decode and compile it synchronously. What is returned does so ahead
 * and off the main thread; it throws "not-loaded" where nothing may be compiled, as that would.
 */
export function embed(part: Part, text: string, swaps: readonly number[]): () => Promise<void> {
  let compiled: WebAssembly.Module | undefined;
  setSource(part, () => {
    try {
      return (compiled ??= new WebAssembly.Module(bytesOf(text, swaps)));
    } catch (cause) {
      throw notCompiled(cause);
    }
  });
  return async () => {
    await null; // the end of the caller's stack may be near
    if (compiled !== undefined || (part === "core" && isRunning())) return;
    try {
      compiled ??= await WebAssembly.compile(bytesOf(text, swaps));
      if (part === "core") start(compiled);
    } catch (cause) {
      throw notCompiled(cause);
    }
  };
}

/** The bytes that a text stands for. */
function bytesOf(text: string, swaps: readonly number[]): Uint8Array<ArrayBuffer> {
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
