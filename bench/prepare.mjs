// Builds the contenders and makes the sets.
import { existsSync, mkdirSync, statSync } from "node:fs";
import path from "node:path";
import { installPacked } from "../tests/wasm/support/install_packed.mjs";
import { buildPackage } from "../tools/build.mjs";
import { ensureBoost } from "../tools/toolchain/boost.mjs";
import { buildWithCmake } from "../tools/toolchain/cmake.mjs";
import { withBuildLock } from "../tools/toolchain/lock.mjs";
import { ensureNativeTools } from "../tools/toolchain/native.mjs";
import { run, say } from "../tools/toolchain/process.mjs";
import { writeCities } from "./cities.mjs";
import { native, sets } from "./places.mjs";

export const hasCgal = ["/usr/include", "/usr/local/include"].some((folder) =>
  existsSync(`${folder}/CGAL/version.h`),
);

async function buildNative() {
  ensureNativeTools();
  ensureBoost();
  await withBuildLock(() => {
    const settings = {
      CMAKE_BUILD_TYPE: "Release",
      APOLLONIUS_TESTS: "OFF",
      BENCH_CGAL: hasCgal ? "ON" : "OFF",
    };
    const target = ["bench_sites", "native_bench", ...(hasCgal ? ["cgal_bench"] : [])];
    buildWithCmake("bench", settings, { target });
  });
  if (!hasCgal) say("CGAL is left out: install libcgal-dev to compare with it");
}

/** Trees and windows, which js/treemaps.mjs and js/growth.mjs make. */
const kWithoutFile = ["flare", "tree", "disc", "ring", "star", "jagged", "rim"];

/** Builds everything. */
export async function buildContenders() {
  await buildPackage();
  installPacked();
  await buildNative();
}

/**
 * The path of a set without extension; it is made if it is missing or older than the program that
 * makes it.
 */
export function ensureSet(family, n) {
  const stem = path.join(sets, `${family}-${n}`);
  if (kWithoutFile.includes(family)) return stem;
  const maker = path.join(native, "bench_sites");
  const isFresh =
    existsSync(`${stem}.near`) && statSync(`${stem}.near`).mtimeMs > statSync(maker).mtimeMs;
  if (isFresh) return stem;
  mkdirSync(sets, { recursive: true });
  if (family === "cities") writeCities(`${stem}.sites`);
  run(maker, [sets, family, String(n)]);
  return stem;
}
