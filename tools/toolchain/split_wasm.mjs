// Splits the wasm module in two (Binaryen's wasm-split): apollonius.wasm for all, and sphere.wasm
// with what only the diagram of the sphere calls, which works in the memory and the tables of the
// first. Whoever does not import apollonius-diagram/sphere does not load the second.
import { copyFileSync, existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { run } from "./process.mjs";

/** Names of functions that belong to the second part: of src/sphere, its bindings, and libm. */
const names = [
  /\bsphere::|Spheric|IntoSphere|sphereFromBytes/,
  /^(_*(sin|cos|rem_pio2\w*)|atan2?|hypot|remainder|scalbn)$/,
];
/** Of those, what runs when the module starts. */
const atStart = /value_object|class_<|register/;
const isOfSphere = (name) => names.some((pattern) => pattern.test(name)) && !atStart.test(name);

/** What the module is compiled with (cmake/CompileFlags.cmake). */
const features = [
  "exception-handling",
  "simd",
  "bulk-memory",
  "nontrapping-float-to-int",
  "sign-ext",
  "mutable-globals",
];

/** The names of functions in a module, which was linked with them. */
function functionNames(bytes) {
  const [section] = WebAssembly.Module.customSections(new WebAssembly.Module(bytes), "name");
  const encoded = Buffer.from(section);
  let at = 0;
  const number = () => {
    let value = 0;
    for (let shift = 1; ; shift *= 128) {
      const byte = encoded[at++];
      value += (byte & 127) * shift;
      if (byte < 128) return value;
    }
  };
  const found = [];
  while (at < encoded.length) {
    const kind = encoded[at++];
    const end = number() + at;
    if (kind === 1) {
      for (let count = number(); count > 0; --count) {
        number(); // the function's index
        const length = number();
        found.push(encoded.toString("utf8", at, at + length));
        at += length;
      }
    }
    at = end;
  }
  return found;
}

/** As Binaryen writes names. */
const escaped = (name) =>
  name.replaceAll(
    /[^\w!#$%&'*+\-./:<=>?@\\^`|~]/g,
    (character) => `\\${character.charCodeAt(0).toString(16).padStart(2, "0")}`,
  );

function wasmSplit(emscripten) {
  const places = ["../binaryen/bin", "../bin", "/usr/bin"];
  const found = places
    .map((place) => path.resolve(emscripten, place, "wasm-split"))
    .find((file) => existsSync(file));
  if (found === undefined) throw new Error(`no wasm-split beside ${emscripten}`);
  return found;
}

/** A module with nothing in it. */
const empty = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0);

/**
 * Splits apollonius.wasm of a build folder into two of that folder's parts/. For debuggers the
 * first is the whole, which its source map knows.
 */
export function splitWasm(emscripten, built, { debug = false } = {}) {
  const whole = path.join(built, "apollonius.wasm");
  const parts = path.join(built, "parts");
  mkdirSync(parts, { recursive: true });
  if (debug) {
    copyFileSync(whole, path.join(parts, "apollonius.wasm"));
    writeFileSync(path.join(parts, "sphere.wasm"), empty);
    return;
  }
  const chosen = functionNames(readFileSync(whole)).filter(isOfSphere);
  const list = path.join(parts, "sphere.txt");
  writeFileSync(list, `${chosen.map(escaped).join("\n")}\n`);
  run(wasmSplit(emscripten), [
    whole,
    "-o1",
    path.join(parts, "apollonius.wasm"),
    "-o2",
    path.join(parts, "sphere.wasm"),
    `--split-funcs=@${list}`,
    "--placeholder-namespace=later", // wasm/package/native/module.ts knows both
    "--import-namespace=first",
    ...features.map((feature) => `--enable-${feature}`),
  ]);
}
