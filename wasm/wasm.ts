// The entry `apollonius-diagram/wasm`: the same names, with the wasm kept in a file of its own
// (`apollonius-diagram/apollonius.wasm`).
import { isRunning, setModuleSource, start } from "./module.js";

export * from "./api.js";

/**
 * Where the wasm comes from: its address, a response (streamed), its bytes, or a compiled module.
 */
export type WasmSource =
  | string
  | URL
  | Response
  | PromiseLike<Response>
  | BufferSource
  | WebAssembly.Module;

setModuleSource(() => {
  throw new Error("apollonius-diagram/wasm: `await load(source)` before the first diagram");
});

async function compiled(source: WasmSource): Promise<WebAssembly.Module> {
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source))
    return WebAssembly.compile(source as BufferSource);
  const response = await (typeof source === "string" || source instanceof URL
    ? fetch(source)
    : source);
  if (!(response instanceof Response)) {
    throw new TypeError(
      "apollonius-diagram/wasm: load() expects an address, a Response, the bytes " +
        "or a WebAssembly.Module",
    );
  }
  if (!response.ok)
    throw new Error(`apollonius-diagram/wasm: ${response.url} answered ${response.status}`);
  const isWasm = response.headers.get("content-type")?.startsWith("application/wasm");
  return isWasm
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer());
}

/** Compiles the wasm; to be awaited before the first diagram. Later calls do nothing. */
export async function load(source: WasmSource): Promise<void> {
  if (!isRunning()) start(await compiled(source));
}
