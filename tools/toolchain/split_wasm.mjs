// Splits the wasm module into its parts (Binaryen's wasm-split): core.wasm, and shapes.wasm and
// sphere.wasm, which work in the memory and the table of core. A program that does not call a part
// does not load it.
//
// The part of a function is that of the folder in which it is defined, as the object files tell.
import { copyFileSync, existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { devNull } from "node:os";
import path from "node:path";
import { capture, run } from "./process.mjs";

/** The parts. The others call `core`, and not each other. */
export const parts = ["core", "shapes", "sphere"];

/** The folders of the parts beside core, as they occur in the paths of object files. */
const rooms = {
  shapes: /\/src\/(geometry|api\/shapes)\/|\/bindings\/shapes\./,
  sphere: /\/src\/(sphere|api\/sphere)\/|\/bindings\/sphere\./,
};
/** The first calls of a part by JavaScript (wasm/bindings/parts.h), through exports of core. */
const registrations = { registerShapes: "shapes", registerSphere: "sphere" };

/**
 * Features that the module is compiled with (cmake/CompileFlags.cmake), and those that places of
 * the table without a function need; browsers have had that longer than SIMD.
 */
const features = [
  "reference-types",
  "exception-handling",
  "simd",
  "bulk-memory",
  "nontrapping-float-to-int",
  "sign-ext",
  "mutable-globals",
].map((feature) => `--enable-${feature}`);

/** The part of a function that both parts call. */
const common = (a, b) => (a === b ? a : "core");

/** The part of each function that the object files define; `core` if those of several do. */
function partsByFolder(emscripten, built) {
  // Only sources that are there: a file that was moved has left its object file.
  const compiled = readFileSync(path.join(built, "compile_commands.json"), "utf8");
  const objects = [...compiled.matchAll(/ -o (CMakeFiles\/apollonius(?:_wasm)?\.dir\/\S+\.o) /g)];
  const output = capture(path.join(emscripten, "emnm"), [
    "-A",
    "--defined-only",
    ...objects.map(([, file]) => path.join(built, file)),
  ]);
  const found = new Map();
  for (const [, object, name] of output.matchAll(/^(.*): [0-9a-f]+ [tTwW] (.*)$/gm)) {
    const part = parts.find((candidate) => rooms[candidate]?.test(object)) ?? "core";
    found.set(name, common(part, found.get(name) ?? part));
  }
  return found;
}

/** The functions of a module and whom each calls directly. */
function callsIn(whole, tool) {
  const graph = capture(tool("wasm-opt"), [
    whole,
    "--print-call-graph",
    ...features,
    "-o",
    devNull,
  ]);
  const unescaped = (name) =>
    name.replaceAll(/\\([0-9a-f]{2})/g, (_, code) =>
      String.fromCharCode(Number.parseInt(code, 16)),
    );
  const calls = new Map();
  for (const [, name, kind] of graph.matchAll(/^ {2}"(\S+)" \[.*fillcolor="(\w+)"\];$/gm))
    if (kind !== "turquoise") calls.set(unescaped(name), []); // which are imported
  for (const [, from, to] of graph.matchAll(/^ {2}"(\S+)" -> "(\S+)"; \/\/ call$/gm))
    calls.get(unescaped(from)).push(unescaped(to));
  return calls;
}

/**
 * The part of each function of the module. A function that no folder of ours defines, as of the C
 * library, is in the part that calls it. A function that another part than its own calls is in
 * `core`: an inline function of which the linker has kept another copy.
 */
function partsOfFunctions(emscripten, built, whole, tool) {
  const calls = callsIn(whole, tool);
  const isCalled = new Set([...calls.values()].flat());
  const found = partsByFolder(emscripten, built);
  for (const name of calls.keys())
    if (!isCalled.has(name) && !found.has(name)) found.set(name, "core");
  for (const name in registrations) found.set(name, registrations[name]);
  for (let isChanged = true; isChanged; ) {
    isChanged = false;
    for (const [name, callees] of calls) {
      const part = found.get(name);
      if (part === undefined) continue; // not yet
      for (const callee of callees) {
        if (!calls.has(callee) || callee in registrations) continue;
        const before = found.get(callee);
        const after = common(part, before ?? part);
        if (after === before) continue;
        found.set(callee, after);
        isChanged = true;
      }
    }
  }
  return new Map([...calls.keys()].map((name) => [name, found.get(name) ?? "core"]));
}

/** A program of Binaryen's. */
function binaryen(emscripten, name) {
  const places = ["../binaryen/bin", "../bin", "/usr/bin"];
  const found = places
    .map((place) => path.resolve(emscripten, place, name))
    .find((file) => existsSync(file));
  if (found === undefined) throw new Error(`no ${name} beside ${emscripten}`);
  return found;
}

/** A module with nothing in it. */
const empty = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0);

/**
 * Splits apollonius.wasm of a build folder into the parts, in that folder's parts/. For debuggers
 * the first is the whole, which its source map knows.
 */
export function splitWasm(emscripten, built, { debug = false } = {}) {
  const whole = path.join(built, "apollonius.wasm");
  const out = path.join(built, "parts");
  const fileOf = (part) => path.join(out, `${part}.wasm`);
  mkdirSync(out, { recursive: true });
  if (debug) {
    for (const part of parts) writeFileSync(fileOf(part), empty);
    copyFileSync(whole, fileOf("core"));
    return;
  }
  const tool = (name) => binaryen(emscripten, name);
  const found = partsOfFunctions(emscripten, built, whole, tool);
  // One part after the other is split off, the last one first.
  let rest = whole;
  let nameOf = (name) => name;
  for (const part of parts.slice(1).reverse()) {
    const names = [...found].filter(([, own]) => own === part).map(([name]) => nameOf(name));
    const list = path.join(out, `${part}.txt`);
    writeFileSync(list, `${names.join("\n")}\n`);
    const before = path.join(out, `before_${part}.wasm`);
    run(tool("wasm-split"), [
      rest,
      "--symbolmap",
      "-o1",
      before,
      "-o2",
      fileOf(part),
      `--split-funcs=@${list}`,
      // Without the part there is nothing in its places in the table. An imported function in each
      // would take V8 11 ms: it compiles a wrapper for each signature before core starts.
      "--no-placeholders",
      "--import-namespace=core", // wasm/package/core/native/module.ts knows it
      `--export-prefix=${part[1]}`, // one of each part
      ...features,
    ]);
    rest = before;
    nameOf = namesIn(before);
  }
  for (const part of parts) {
    const from = part === "core" ? rest : fileOf(part);
    run(tool("wasm-opt"), [from, "-O3", "--converge", ...features, "-o", fileOf(part)]);
  }
}

/** Binaryen's names of the functions of a module without names, by their names in its map. */
function namesIn(file) {
  const imports = WebAssembly.Module.imports(new WebAssembly.Module(readFileSync(file)));
  const imported = imports.filter(({ kind }) => kind === "function").length;
  const names = new Map();
  for (const [, index, name] of readFileSync(`${file}.symbols`, "utf8").matchAll(/^(\d+):(.*)$/gm))
    names.set(name, String(Number(index) - imported));
  return (name) => names.get(name) ?? name;
}
