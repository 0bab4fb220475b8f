// npm test: sets up, builds, and runs everything, in lanes side by side (side_by_side.mjs).
// npm test -- native wasm      runs some steps only
// npm test -- native -t Ids    only tests with that in their names
// npm test -- changed          the tests nearest to what has changed since HEAD (changed.mjs)
//
//   lint      layout and rules of the sources, which need no build
//   native    the C++ tests, natively, with one of seven filtered predicate answers compared to the
//             exact one (each one: npm run check -- shadow)
//   wasm      those of them whose answer may differ there as WebAssembly under Node
//             (cmake/WasmTests.cmake)
//   package   Jest on the package as `npm pack` makes it (in Node, in browsers, through bundlers),
//             and on the rules about who may include whom
//   cluster   Jest on web/examples/cluster, with a real Redis
//   web       types of the page and of the examples, and Jest on the page in real browsers
import { readdirSync } from "node:fs";
import path from "node:path";
import { buildPackage } from "../tools/build.mjs";
import { checkPage, lint } from "../tools/lint.mjs";
import { ensureChromium, ensureFirefox } from "../tools/toolchain/browser.mjs";
import { ensureBoost } from "../tools/toolchain/boost.mjs";
import { buildWasmTests, buildWithCmake } from "../tools/toolchain/cmake.mjs";
import { ensureEmscripten } from "../tools/toolchain/emscripten.mjs";
import { withBuildLock } from "../tools/toolchain/lock.mjs";
import { ensureNativeTools } from "../tools/toolchain/native.mjs";
import { SetUpError } from "../tools/toolchain/process.mjs";
import { ensureRedis } from "../tools/toolchain/redis.mjs";
import { main } from "../tools/toolchain/setup.mjs";
import { changedFiles, clusterPlan, nativePlan, packagePlan, pagePlan } from "./changed.mjs";
import { runPrograms } from "./programs.mjs";
import { runSideBySide } from "./side_by_side.mjs";
import { checkNames, ctest, jest, runLanes, runTests } from "./steps.mjs";
import { installPacked } from "./wasm/support/install_packed.mjs";

const wanted = process.argv.slice(2);
const at = wanted.indexOf("-t");
/** Part of the names of the tests that are run; undefined: all. */
const name = at < 0 ? undefined : wanted.splice(at, 2)[1];

/** Runs the programs themselves: as wasm, CTest knows no single tests. */
async function wasmTests(folder) {
  if (name === undefined) return ctest(folder);
  const programs = readdirSync(folder).filter((file) => file.endsWith("_tests.js"));
  for (const program of programs) {
    const args = [path.join(folder, program), `--gtest_filter=*${name}*`, "--gtest_brief=1"];
    await runTests(process.execPath, args, { summary: /PASSED/, boring: /PASSED +. 0 tests/ });
  }
  return `${programs.length} programs without a failure`;
}

/** The programs with the shadow check, or a target of them; returns their folder. */
function buildNative(target) {
  ensureNativeTools();
  ensureBoost();
  const settings = {
    CMAKE_BUILD_TYPE: "Release",
    APOLLONIUS_SHADOW_CHECK: "7", // no multiple of the 2, 3, 6 questions that are asked in turn
    APOLLONIUS_BATCH: "ON",
    APOLLONIUS_WERROR: "ON",
  };
  return withBuildLock(() => buildWithCmake("native", settings, { target }));
}

async function somePrograms(filters) {
  const folder = await buildNative([...filters.keys()]);
  return runPrograms(folder, { filters });
}

async function packageTests(projects, more) {
  const browsers = { CHROMIUM: ensureChromium() ?? "", FIREFOX: ensureFirefox() ?? "" };
  await buildPackage();
  installPacked();
  const line = await jest(projects, { name, env: browsers, more });
  const missing = Object.keys(browsers).filter((browser) => browsers[browser] === "");
  return missing.length === 0
    ? line
    : `${line}   WITHOUT ${missing.join(" AND ")}: install it, or set that variable to its path`;
}

async function clusterTests() {
  const redis = ensureRedis();
  if (redis === null && process.env.CI) {
    throw new SetUpError("no redis-server, and apt has none that could be installed");
  }
  await buildPackage();
  const line = await jest(["cluster"], { name, env: { REDIS_SERVER: redis ?? "" } });
  return redis ? line : `${line}   WITHOUT REDIS: install redis-server`;
}

async function pageTests(more) {
  const chromium = ensureChromium();
  const firefox = ensureFirefox();
  if (chromium === null && process.env.CI) {
    throw new SetUpError(
      "no browser: none is installed, and apt has no package `chromium` that could be installed",
    );
  }
  await buildPackage();
  checkPage();
  const env = { CHROMIUM: chromium ?? "", FIREFOX: firefox ?? "" };
  const line = await jest(["web"], { name, env, more });
  return chromium
    ? line
    : `${line}   WITHOUT A BROWSER: install Chromium, or set CHROMIUM to its path`;
}

const steps = {
  lint() {
    if (name !== undefined) return "has no tests";
    lint();
    return "nothing to say";
  },
  async native() {
    const folder = await buildNative("all");
    if (name !== undefined) return ctest(folder, { name, orNone: true });
    const line = await runPrograms(folder);
    await ctest(folder, { name: "^(flags|install|fuzz/)" }); // tests that are in no program
    return `${line}; flags, install and fuzz corpora passed`;
  },
  async wasm() {
    ensureNativeTools();
    const emscripten = ensureEmscripten();
    ensureBoost();
    return wasmTests(await withBuildLock(() => buildWasmTests(emscripten)));
  },
  package: () => packageTests(["package", "layers"]),
  cluster: clusterTests,
  web: () => pageTests(),
};

/** The steps for the changed files, each with the tests that it leaves out. */
function stepsOfChange() {
  const files = changedFiles();
  const programs = nativePlan(files);
  const ofPackage = packagePlan(files);
  const page = pagePlan(files);
  return [
    ["lint", steps.lint],
    ...(programs.size > 0 ? [["native", () => somePrograms(programs)]] : []),
    ...(ofPackage ? [["package", () => packageTests(["package", "layers"], ofPackage)]] : []),
    ...(clusterPlan(files) ? [["cluster", clusterTests]] : []),
    ...(page.length > 0 ? [["web", () => pageTests(["--testPathPatterns", ...page])]] : []),
  ];
}

await main(async () => {
  if (wanted[0] === "changed") return runLanes([stepsOfChange()]);
  checkNames(steps, wanted);
  const names = wanted.length > 0 ? wanted : Object.keys(steps);
  if (names.length > 1) return runSideBySide(names, name === undefined ? [] : ["-t", name]);
  return runLanes([[[names[0], steps[names[0]]]]]);
});
