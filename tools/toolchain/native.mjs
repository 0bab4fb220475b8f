// Tools of the native build: a C++20 compiler, CMake, GoogleTest's sources.
import { spawnSync } from "node:child_process";
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

/** Installs a tool of tests/check.mjs or tests/coverage.mjs if it is missing; returns its name. */
function ensureTool(program, packages, why) {
  if (!which(program)) ensureInstalled(packages, why);
  return program;
}

export function ensureClang() {
  return ensureTool("clang++-14", ["clang-14", "libclang-rt-14-dev"], "building with clang++");
}

export function ensureClangTidy() {
  return ensureTool("clang-tidy-14", ["clang-tidy-14"], "clang-tidy");
}

/** llvm-profdata and llvm-cov of the same version as clang++. */
export function ensureCoverageTools() {
  return ["llvm-profdata-14", "llvm-cov-14"].map((program) =>
    ensureTool(program, ["llvm-14"], "coverage"),
  );
}

export function ensureCppcheck() {
  return ensureTool("cppcheck", ["cppcheck"], "cppcheck");
}

export function ensureValgrind() {
  // Without libc's symbols it refuses to start.
  return ensureTool("valgrind", ["valgrind", "libc6-dbg"], "valgrind");
}

/**
 * Installs what `g++ -m32` needs. Returns what to run its programs with: nothing, or an emulator
 * where the kernel does not run such programs (glibc's loader is one, and tells).
 */
export function ensureThirtyTwoBits() {
  if (
    !existsSync("/usr/include/gnu/stubs-32.h") &&
    !existsSync("/usr/include/x86_64-linux-gnu/gnu/stubs-32.h")
  ) {
    ensureInstalled(["g++-multilib"], "32-bit builds");
  }
  if (spawnSync("/lib/ld-linux.so.2", ["--version"]).status === 0) return [];
  return [ensureTool("qemu-i386", ["qemu-user"], "32-bit programs")];
}

export function ensureNativeTools() {
  ensureMissing(needs, "the C++ build and its tests");
}

function ensureMissing(list, why) {
  const missing = list.filter((need) => !need.isThere()).flatMap((need) => need.packages);
  if (missing.length > 0) ensureInstalled(missing, why);
}
