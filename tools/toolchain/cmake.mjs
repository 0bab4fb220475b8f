// Builds with CMake in folders under build/.
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import path from "node:path";
import { cmakeToolchainFile } from "./emscripten.mjs";
import { root } from "./folders.mjs";
import { capture, run } from "./process.mjs";

export const jobs = String(availableParallelism());

/** Configures if the arguments are new (CMake itself notices changed files); returns the folder. */
export function configureWithCmake(name, settings, { env } = {}) {
  const folder = path.join(root, "build", name);
  const args = Object.entries(settings).map(([key, value]) => `-D${key}=${value}`);
  const stamp = path.join(folder, ".arguments");
  const wanted = [root, ...args].join("\n"); // a clone that was moved starts afresh too
  if (!existsSync(stamp) || readFileSync(stamp, "utf8") !== wanted) {
    mkdirSync(folder, { recursive: true });
    rmSync(stamp, { force: true });
    capture("cmake", ["--fresh", "-S", root, "-B", folder, ...args], { env });
    writeFileSync(stamp, wanted);
  }
  return folder;
}

/** Configures, then builds a target, or several; returns the folder. */
export function buildWithCmake(name, settings, { target = "all", env } = {}) {
  const folder = configureWithCmake(name, settings, { env });
  run("cmake", ["--build", folder, "--parallel", jobs, "--target", ...[target].flat()], { env });
  return folder;
}

/**
 * The module and the C++ tests as wasm are built in one folder, of the same objects. Warnings are
 * errors only in CI, so that the build also works with a newer Emscripten.
 */
function buildWasm(emscripten, target, { debug = false, allTests = false } = {}) {
  const hasGoogleTest = existsSync("/usr/src/googletest/CMakeLists.txt"); // `npm test` installs it
  const settings = {
    CMAKE_TOOLCHAIN_FILE: cmakeToolchainFile(emscripten),
    APOLLONIUS_TESTS: hasGoogleTest && !debug ? "ON" : "OFF",
    ...(process.env.CI && { APOLLONIUS_WERROR: "ON" }),
    ...(debug ? { CMAKE_BUILD_TYPE: "Debug" } : { APOLLONIUS_BATCH: "ON" }),
    ...(allTests && { APOLLONIUS_ALL_WASM_TESTS: "ON" }),
  };
  const folder = debug ? "debug/wasm" : allTests ? "all-wasm" : "wasm";
  return buildWithCmake(folder, settings, { target });
}

/** The wasm module for the package. */
export const buildWasmModule = (emscripten, options) =>
  buildWasm(emscripten, "apollonius_wasm", options);

/** The C++ tests as wasm: those of cmake/WasmTests.cmake, or `allTests`. */
export const buildWasmTests = (emscripten, options) => buildWasm(emscripten, "all", options);
