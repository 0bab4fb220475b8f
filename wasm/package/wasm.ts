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
export { Diagram, type DiagramClass, type Voronoi } from "./shapes/methods.js";
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

/** The version of this package (tools/build.mjs). */
declare const VERSION: string;

/**
 * The kind of a source, whichever realm it comes from: sandboxes as Next's for edge functions
 * compile the module outside.
 */
const kindOf = (source: unknown): string => Object.prototype.toString.call(source).slice(8, -1);
const isModule = (source: unknown): source is WebAssembly.Module =>
  kindOf(source) === "WebAssembly.Module";
const isResponse = (source: unknown): source is Response => kindOf(source) === "Response";

async function compiled(part: Part, source: WasmSource): Promise<WebAssembly.Module> {
  await null; // the end of the caller's stack may be near
  if (kindOf(source) === "ArrayBuffer" || ArrayBuffer.isView(source))
    return compiledBytes(part, source as BufferSource, part);
  const response = await received(part, source);
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
  const bytes = await copy.arrayBuffer().catch((cause: unknown) => {
    throw cause instanceof RangeError ? cause : notLoaded(`${name} ended early`, cause);
  });
  return compiledBytes(part, bytes, name);
}

/** Compiles bytes; throws "not-loaded", with the first of them, if they are something else. */
async function compiledBytes(
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
  try {
    return await WebAssembly.compile(source);
  } catch (cause) {
    // Policies forbid to compile, and not to validate.
    if (cause instanceof RangeError || WebAssembly.validate(source)) throw cause;
    throw notLoaded(`${name} is cut off or damaged: ${(cause as Error).message}`, cause);
  }
}

/** Says in a part, as "core 1.0.0", what it is (tools/build.mjs). */
const kSection = "apollonius-diagram";

/** Throws "not-loaded" unless the module is this part, of this version. */
function checkPart(part: Part, module: WebAssembly.Module): void {
  const { Module } = WebAssembly;
  const expected = `${part} ${VERSION}`;
  const [section] = Module.customSections(module, kSection);
  if (section === undefined) {
    // Tools that make modules smaller may have taken it out.
    const from = Module.imports(module)[0]?.module;
    if (from === (part === "core" ? "env" : "core")) return;
  }
  const given = section === undefined ? "of something else" : new TextDecoder().decode(section);
  if (given === expected) return;
  throw notLoaded(
    `${part} is given WebAssembly ${given}, expected ${expected}, the file ${part}.wasm`,
  );
}

/** The first bytes of all WebAssembly: NUL, "asm". */
const kMagic = [0, 0x61, 0x73, 0x6d];

/** The response from an address, or that which is given or promised. */
async function received(part: Part, source: WasmSource): Promise<unknown> {
  const isAddress = typeof source === "string" || kindOf(source) === "URL";
  try {
    return await (isAddress ? fetch(source as string | URL) : source);
  } catch (cause) {
    const isFile = String(source).startsWith("file:");
    const hint = isFile ? ": of a file give the bytes, await readFile(new URL(…))" : "";
    const name = isAddress ? String(source) : `the response for ${part}`;
    throw notLoaded(`${name} cannot be fetched${hint}`, cause);
  }
}

const kParts: readonly Part[] = ["core", "shapes", "sphere"];
const loaded = new Set<Part>();

async function loadPart(part: Part, source: WasmSource): Promise<void> {
  try {
    const module = isModule(source) ? source : await compiled(part, source);
    checkPart(part, module);
    // A module that is given starts with its first use, as nothing was to be waited for.
    if (part === "core" && module !== source) start(module);
    setSource(part, () => module);
    loaded.add(part);
  } catch (error) {
    throw notCompiled(error);
  }
}

/**
 * Compiles the parts that are wanted, in any order; to be awaited before the first call that needs
 * them. What is there already is not loaded again. Throws "not-loaded" (no answer from an address,
 * or what it gives is another file or of another version, or nothing can be compiled),
 * "out-of-memory", "bad-option" (an unknown part, or none of the sources).
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
