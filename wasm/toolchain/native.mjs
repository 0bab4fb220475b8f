// What the native build needs: a C++20 compiler, CMake, GoogleTest's sources.
import { existsSync } from "node:fs";
import { ensureInstalled } from "./apt.mjs";
import { which } from "./process.mjs";

const needs = [
  { isThere: () => which("g++") || which("clang++") || process.env.CXX, packages: ["g++"] },
  { isThere: () => which("cmake"), packages: ["cmake"] },
  { isThere: () => which("make") || process.env.CMAKE_GENERATOR, packages: ["make"] },
  { isThere: () => existsSync("/usr/src/googletest/CMakeLists.txt"), packages: ["libgtest-dev"] },
];

/** CMake and make: for the wasm build too. */
export function ensureCmake() {
  ensureMissing(needs.slice(1, 3), "building");
}

export function ensureNativeTools() {
  ensureMissing(needs, "the C++ build and its tests");
}

function ensureMissing(list, why) {
  const missing = list.filter((need) => !need.isThere()).flatMap((need) => need.packages);
  if (missing.length > 0) ensureInstalled(missing, why);
}
