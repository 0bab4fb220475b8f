// The entry `apollonius-diagram/wasm`: the names of all other entries, with the wasm kept in files
// of their own (`apollonius-diagram/core.wasm`, `shapes.wasm`, `sphere.wasm`).
import { checkOptions, described } from "./core/arguments.js";
import {
  isRunning,
  notCompiled,
  notLoaded,
  type Part,
  setSource,
  start,
} from "./core/native/module.js";
import { ApolloniusError } from "./errors.js";

export * from "./core/api.js";
export * from "./shapes/api.js";
export { enclose } from "./shapes/enclose.js";
export { Diagram } from "./shapes/methods.js";
export * from "./sphere/api.js";
export * from "./treemap/api.js";

/**
 * Where a part of the wasm comes from: its address, a response (streamed), its bytes, or a compiled
 * module.
 */
export type WasmSource =
  | string
  | URL
  | Response
  | PromiseLike<Response>
  | BufferSource
  | WebAssembly.Module;

/** The parts that are wanted, and where each comes from. */
export interface WasmSources {
  /** Diagrams and their queries: `apollonius-diagram/core.wasm`. All others need it. */
  core?: WasmSource;
  /** Windows, drawings, treemaps: `apollonius-diagram/shapes.wasm`. */
  shapes?: WasmSource;
  /** `SphericalDiagram`: `apollonius-diagram/sphere.wasm`. */
  sphere?: WasmSource;
}

/**
 * What it is, whichever realm it comes from: sandboxes as Next's for edge functions compile the
 * module outside.
 */
const kindOf = (source: unknown): string => Object.prototype.toString.call(source).slice(8, -1);
const isModule = (source: unknown): source is WebAssembly.Module =>
  kindOf(source) === "WebAssembly.Module";
const isResponse = (source: unknown): source is Response => kindOf(source) === "Response";

async function compiled(part: Part, source: WasmSource): Promise<WebAssembly.Module> {
  if (kindOf(source) === "ArrayBuffer" || ArrayBuffer.isView(source))
    return compiledBytes(part, source as BufferSource, part);
  const isAddress = typeof source === "string" || kindOf(source) === "URL";
  const response = await (isAddress ? fetched(source as string | URL) : source);
  if (!isResponse(response)) {
    throw new ApolloniusError(
      "bad-option",
      `${part} is ${described(response)}, expected an address, a Response, the bytes ` +
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
  return compiledBytes(part, await copy.arrayBuffer(), name);
}

/** Compiles bytes; throws "not-loaded", with the first of them, if they are something else. */
function compiledBytes(
  part: Part,
  source: BufferSource,
  name: string,
): Promise<WebAssembly.Module> {
  const { buffer, byteOffset, byteLength } = ArrayBuffer.isView(source)
    ? source
    : { buffer: source, byteOffset: 0, byteLength: source.byteLength };
  const first = new Uint8Array(buffer, byteOffset, Math.min(byteLength, 40));
  if (first.length < 4 || !kMagic.every((byte, k) => byte === first[k])) {
    const text = new TextDecoder().decode(first);
    throw notLoaded(
      `${name} is no WebAssembly: it begins with ${JSON.stringify(text)}. The file is ` +
        `${part}.wasm of this package; many servers answer a missing file with an HTML page`,
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
    const hint = isFile ? ": of a file give the bytes, await readFile(new URL(…))" : "";
    throw notLoaded(`${address} cannot be fetched${hint}`, cause);
  }
}

const kParts: readonly Part[] = ["core", "shapes", "sphere"];
const loaded = new Set<Part>();

async function loadPart(part: Part, source: WasmSource): Promise<void> {
  try {
    const module = isModule(source) ? source : await compiled(part, source);
    // A module that is given starts with its first use, as nothing was to be waited for.
    if (part === "core" && module !== source) start(module);
    setSource(part, () => module);
    loaded.add(part);
  } catch (error) {
    throw error instanceof ApolloniusError ? error : notCompiled(error);
  }
}

/**
 * Compiles the parts that are wanted; to be awaited before the first call that needs them. What is
 * there already is not loaded again. Throws "not-loaded" (no answer from an address, or what it
 * gives cannot be compiled, or nothing can), "bad-option" (an unknown part, or none of the
 * sources).
 */
export async function load(sources: WasmSources): Promise<void> {
  if (kindOf(sources) !== "Object")
    throw new ApolloniusError(
      "bad-option",
      `sources is ${described(sources)}, expected { core, shapes, sphere }`,
    );
  checkOptions(sources, ...kParts);
  const isThere = (part: Part) => loaded.has(part) || (part === "core" && isRunning());
  const wanted = kParts.filter((part) => part in sources && !isThere(part));
  await Promise.all(wanted.map((part) => loadPart(part, sources[part] as WasmSource)));
}
