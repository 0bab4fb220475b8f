// Builds the contenders and makes the sets.
import { existsSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import path from "node:path";
import { ensureBoost } from "../tools/toolchain/boost.mjs";
import { buildWithCmake } from "../tools/toolchain/cmake.mjs";
import { withBuildLock } from "../tools/toolchain/lock.mjs";
import { ensureNativeTools } from "../tools/toolchain/native.mjs";
import { capture, run, say } from "../tools/toolchain/process.mjs";
import { writeCities } from "./cities.mjs";
import { native, packed, root, sets } from "./places.mjs";

export const hasCgal = ["/usr/include", "/usr/local/include"].some((folder) =>
  existsSync(`${folder}/CGAL/version.h`),
);

/** The package as users get it: packed by npm and installed in a folder of its own. */
function installPackage() {
  run(process.execPath, [path.join(root, "tools/build.mjs")]);
  const stamp = path.join(packed, "fingerprint");
  const fingerprint = readFileSync(path.join(root, "build/dist.fingerprint"), "utf8");
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === fingerprint) return;
  say("packing the package");
  rmSync(packed, { recursive: true, force: true });
  mkdirSync(packed, { recursive: true });
  const [{ filename }] = JSON.parse(
    capture("npm", ["pack", "--json", "--loglevel=error", "--pack-destination", packed], {
      cwd: root,
    }),
  );
  writeFileSync(
    path.join(packed, "package.json"),
    JSON.stringify({ name: "bench-consumer", private: true, type: "module" }),
  );
  // the bare name resolves from here
  writeFileSync(path.join(packed, "consumer.mjs"), 'export * from "apollonius-diagram";\n');
  for (const entry of ["sphere", "treemap"])
    writeFileSync(
      path.join(packed, `${entry}.mjs`),
      `export * from "apollonius-diagram/${entry}";\n`,
    );
  capture(
    "npm",
    ["install", "--offline", "--no-audit", "--no-fund", "--loglevel=error", `./${filename}`],
    { cwd: packed },
  );
  writeFileSync(stamp, fingerprint);
}

async function buildNative() {
  ensureNativeTools();
  ensureBoost();
  await withBuildLock(() => {
    const settings = {
      CMAKE_BUILD_TYPE: "Release",
      APOLLONIUS_TESTS: "OFF",
      BENCH_CGAL: hasCgal ? "ON" : "OFF",
    };
    for (const target of ["bench_sites", "native_bench", ...(hasCgal ? ["cgal_bench"] : [])])
      buildWithCmake("bench", settings, { target });
  });
  if (!hasCgal) say("CGAL is left out: install libcgal-dev to compare with it");
}

const kTrees = ["flare", "tree"];

/** Builds everything; the contenders that there are. */
export async function buildContenders() {
  installPackage();
  await buildNative();
  return hasCgal;
}

/**
 * The path of a set without extension; it is made if it is missing or older than the program that
 * makes it.
 */
export function ensureSet(family, n) {
  const stem = path.join(sets, `${family}-${n}`);
  if (kTrees.includes(family)) return stem; // js/treemaps.mjs makes them
  const maker = path.join(native, "bench_sites");
  const isFresh =
    existsSync(`${stem}.near`) && statSync(`${stem}.near`).mtimeMs > statSync(maker).mtimeMs;
  if (isFresh) return stem;
  mkdirSync(sets, { recursive: true });
  if (family === "cities") writeCities(`${stem}.sites`);
  run(maker, [sets, family, String(n)]);
  return stem;
}
