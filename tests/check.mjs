// npm run check: what looks more closely, or longer, than `npm test` does. A workflow runs it every
// night (.github/workflows/nightly.yml).
// npm run check -- tidy cppcheck    runs some steps only
//
//   sanitizers   the native tests with AddressSanitizer and UndefinedBehaviorSanitizer (smaller
//                sizes: tests/support/effort.h)
//   valgrind     a few of the native tests under memcheck, which knows of uninitialised memory, too
//   tidy         clang-tidy on src/ and wasm/, with the checks of .clang-tidy
//   cppcheck     cppcheck on src/, without what tests/check/cppcheck.txt leaves out
//   thorough     the native tests in their long forms (`sized` in tests/support/effort.h), without
//                the shadow check: whole sets of tens of thousands, lack of memory among thousands
//   shadow       the native tests with each answer of a filter compared with the exact stage
//   wasm         all C++ tests as WebAssembly; `npm test` runs those of cmake/WasmTests.cmake
//   package      the package's tests in their long forms: thousands of treemaps and scenes
//   page         the page's tests in their long forms: storms of 5000 events, axe in each theme on
//                each screen
//   strangers    the package in what is too large for every npm ci: charts, maps, frameworks, other
//                bundlers, other versions of TypeScript, edge runtimes, Deno, Vitest, Observable
//                Framework (tests/strangers)
//   cluster      20 million points and a million circles by the workers of web/examples/cluster, a
//                worker and Redis killed on the way; a hundred kills at random moments
//   links        addresses outside of the project, where there is a network
//   debug        the package of `npm run build -- --debug`: a short test, C++ names in a stack
//                trace, the source map
//   determinism  the recorded hashes with g++ and clang++, -O0 to -O3, 32 bits, the machine's own
//                instructions
//
// APOLLONIUS_DETERMINISM=clang limits the builds of the last one to those whose name has that in
// it.
import path from "node:path";
import { buildDebug, buildPackage } from "../tools/build.mjs";
import { ensureChromium, ensureFirefox } from "../tools/toolchain/browser.mjs";
import { ensureBoost } from "../tools/toolchain/boost.mjs";
import { buildWasmTests, buildWithCmake } from "../tools/toolchain/cmake.mjs";
import { ensureEmscripten } from "../tools/toolchain/emscripten.mjs";
import { withBuildLock } from "../tools/toolchain/lock.mjs";
import { ensureNativeTools, ensureValgrind } from "../tools/toolchain/native.mjs";
import { root } from "../tools/toolchain/folders.mjs";
import { run, SetUpError } from "../tools/toolchain/process.mjs";
import { ensureRedis } from "../tools/toolchain/redis.mjs";
import { cppcheck, tidy } from "./check/analyse.mjs";
import { checkDeterminism } from "./check/determinism.mjs";
import { checkLinks } from "./check/links.mjs";
import { runPrograms } from "./programs.mjs";
import { ctest, jest, runSteps } from "./steps.mjs";
import { installPacked, installPackedDebug } from "./wasm/support/install_packed.mjs";

/**
 * A few of each program: what runs here takes some thirty times as long as natively. None that
 * counts calls of operator new, which valgrind puts its own in the place of; none that changes how
 * the processor rounds, which valgrind does as it always does.
 */
const underValgrind = {
  base_tests: "*",
  topology_tests: "-Room*",
  number_tests: "-Fp.*Seen:FpDeathTest*",
  diagram_tests: "Errors*:Ids*:IdPool*:HiddenForest*:Regressions*:Snapshot.*",
  geometry_tests: "Contacts*:Rings*:VoronoiErrors*",
};

const native = () => {
  ensureNativeTools();
  ensureBoost();
};

await runSteps({
  async sanitizers() {
    native();
    const settings = {
      CMAKE_BUILD_TYPE: "RelWithDebInfo",
      APOLLONIUS_SANITIZE: "ON",
      APOLLONIUS_WERROR: "ON",
    };
    const address = [
      "detect_stack_use_after_return=1",
      "strict_init_order=1",
      "check_initialization_order=1",
      "allocator_may_return_null=1",
    ];
    const env = { ASAN_OPTIONS: address.join(":"), UBSAN_OPTIONS: "print_stacktrace=1" };
    return ctest(await withBuildLock(() => buildWithCmake("sanitizers", settings)), { env });
  },
  async valgrind() {
    native();
    const valgrind = ensureValgrind();
    // The build of `npm test -- native`.
    const settings = {
      CMAKE_BUILD_TYPE: "Release",
      APOLLONIUS_SHADOW_CHECK: "ON",
      APOLLONIUS_WERROR: "ON",
    };
    const folder = await withBuildLock(() => buildWithCmake("native", settings));
    for (const [program, filter] of Object.entries(underValgrind)) {
      run(valgrind, [
        "--quiet",
        "--error-exitcode=1",
        "--leak-check=full",
        "--errors-for-leak-kinds=definite,possible",
        // Where a program brings operators of its own, its new is replaced and its delete is not.
        "--show-mismatched-frees=no",
        path.join(folder, program),
        "--gtest_brief=1",
        `--gtest_filter=${filter}`,
      ]);
    }
    return `${Object.keys(underValgrind).length} programs without an error or a leak`;
  },
  async thorough() {
    native();
    const settings = { CMAKE_BUILD_TYPE: "Release", APOLLONIUS_WERROR: "ON" };
    const folder = await withBuildLock(() => buildWithCmake("release", settings));
    return runPrograms(folder, { envOf: () => ({ APOLLONIUS_THOROUGH: "1" }) });
  },
  async shadow() {
    native();
    const settings = {
      CMAKE_BUILD_TYPE: "Release",
      APOLLONIUS_SHADOW_CHECK: "ON",
      APOLLONIUS_WERROR: "ON",
    };
    return runPrograms(await withBuildLock(() => buildWithCmake("shadow", settings)));
  },
  async wasm() {
    native();
    const emscripten = ensureEmscripten();
    return ctest(await withBuildLock(() => buildWasmTests(emscripten, { allTests: true })));
  },
  async package() {
    const browsers = { CHROMIUM: ensureChromium() ?? "", FIREFOX: ensureFirefox() ?? "" };
    await buildPackage();
    installPacked();
    return jest(["package"], { env: { ...browsers, APOLLONIUS_THOROUGH: "1" } });
  },
  async page() {
    const browsers = { CHROMIUM: ensureChromium() ?? "", FIREFOX: ensureFirefox() ?? "" };
    await buildPackage();
    return jest(["web"], { env: { ...browsers, APOLLONIUS_THOROUGH: "1" } });
  },
  async cluster() {
    const redis = ensureRedis();
    if (redis === null) throw new SetUpError("no redis-server, and apt has none");
    await buildPackage();
    return jest(["cluster"], { env: { REDIS_SERVER: redis, APOLLONIUS_THOROUGH: "1" } });
  },
  links: checkLinks,
  async debug() {
    await buildDebug();
    installPackedDebug();
    return jest(["debug"]);
  },
  async tidy() {
    native();
    return tidy();
  },
  cppcheck,
  async strangers() {
    const browsers = { CHROMIUM: ensureChromium() ?? "", FIREFOX: ensureFirefox() ?? "" };
    await buildPackage();
    installPacked();
    run("npm", ["install", "--prefix", path.join(root, "tests/strangers")]);
    return jest(["strangers"], { env: browsers });
  },
  async determinism() {
    native();
    return withBuildLock(checkDeterminism);
  },
});
