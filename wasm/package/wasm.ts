// The entry `apollonius-diagram/wasm`: the same names, with the wasm kept in a file of its own
// (`apollonius-diagram/apollonius.wasm`).
import { described } from "./arguments.js";
import { ApolloniusError } from "./errors.js";
import { notCompiled, notLoaded, isRunning, setModuleSource, start } from "./native/module.js";

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
  throw notLoaded("apollonius-diagram/wasm: `await load(source)` before the first diagram");
});

/**
 * What it is, whichever realm it comes from: sandboxes as Next's for edge functions compile the
 * module outside.
 */
const kindOf = (source: unknown): string => Object.prototype.toString.call(source).slice(8, -1);
const isModule = (source: unknown): source is WebAssembly.Module =>
  kindOf(source) === "WebAssembly.Module";
const isResponse = (source: unknown): source is Response => kindOf(source) === "Response";

async function compiled(source: WasmSource): Promise<WebAssembly.Module> {
  if (kindOf(source) === "ArrayBuffer" || ArrayBuffer.isView(source))
    return compiledBytes(source as BufferSource, "source");
  const isAddress = typeof source === "string" || kindOf(source) === "URL";
  const response = await (isAddress ? fetched(source as string | URL) : source);
  if (!isResponse(response)) {
    throw new ApolloniusError(
      "bad-option",
      `source is ${described(response)}, expected an address, a Response, the bytes ` +
        "or a WebAssembly.Module",
    );
  }
  if (!response.ok) throw notLoaded(`${response.url} answered ${response.status}`);
  const type = response.headers.get("content-type");
  const copy = response.clone();
  try {
    if (type?.startsWith("application/wasm")) return await WebAssembly.compileStreaming(response);
  } catch {} // of other bytes: these are looked at below
  const name = (response.url || "the response") + (type === null ? "" : ` (${type})`);
  return compiledBytes(await copy.arrayBuffer(), name);
}

/** Compiles bytes; throws "not-loaded", with the first of them, if they are something else. */
function compiledBytes(source: BufferSource, name: string): Promise<WebAssembly.Module> {
  const { buffer, byteOffset, byteLength } = ArrayBuffer.isView(source)
    ? source
    : { buffer: source, byteOffset: 0, byteLength: source.byteLength };
  const first = new Uint8Array(buffer, byteOffset, Math.min(byteLength, 40));
  if (first.length < 4 || !kMagic.every((byte, k) => byte === first[k])) {
    const text = new TextDecoder().decode(first);
    throw notLoaded(
      `${name} is no WebAssembly: it begins with ${JSON.stringify(text)}. The file is ` +
        "apollonius.wasm of this package; many servers answer a missing file with an HTML page",
    );
  }
  return WebAssembly.compile(source);
}

/** What all WebAssembly begins with: NUL, "asm". */
const kMagic = [0, 0x61, 0x73, 0x6d];

async function fetched(address: string | URL): Promise<Response> {
  try {
    return await fetch(address);
  } catch (cause) {
    const isFile = String(address).startsWith("file:");
    const hint = isFile ? ": of a file give the bytes, load(await readFile(new URL(…)))" : "";
    throw notLoaded(`${address} cannot be fetched${hint}`, cause);
  }
}

/**
 * Compiles the wasm; to be awaited before the first diagram. Later calls do nothing. Throws
 * "not-loaded" (no answer from the address, or what it gives cannot be compiled, or nothing can),
 * "bad-option" (none of the sources).
 */
export async function load(source: WasmSource): Promise<void> {
  if (isRunning()) return;
  if (isModule(source)) return setModuleSource(() => source);
  try {
    start(await compiled(source));
  } catch (error) {
    throw error instanceof ApolloniusError ? error : notCompiled(error);
  }
}
