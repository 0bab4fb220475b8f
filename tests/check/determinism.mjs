// The recorded hashes of tests/diagram/determinism_test.cpp and tests/geometry/voronoi_test.cpp
// under other compilers, at other levels of optimisation, and with 32-bit words. (Wasm has them in
// `npm test -- wasm`; Node and browsers, tests/wasm/determinism.test.mjs.)
import { spawnSync } from "node:child_process";
import path from "node:path";
import { buildWithCmake } from "../../tools/toolchain/cmake.mjs";
import { ensureClang, ensureThirtyTwoBits } from "../../tools/toolchain/native.mjs";
import { say, SetUpError } from "../../tools/toolchain/process.mjs";

const levels = ["-O0", "-O1", "-O2", "-O3"];

/** Name, compiler, flags and emulator of each build; `only` chooses among the names. */
function configurations(only) {
  const clang = ensureClang();
  const forThirtyTwoBits = ensureThirtyTwoBits();
  return [
    ...levels.map((level) => ["g++", level]),
    ...levels.map((level) => [clang, level]),
    ["g++", "-O2 -m32", forThirtyTwoBits],
    ["g++", "-O2 -march=native"],
    [clang, "-O2 -march=native"],
  ]
    .map(([compiler, flags, emulator = []]) => ({
      name: `${path.basename(compiler)}${flags.replace(/ /g, "")}`,
      compiler,
      flags,
      emulator,
    }))
    .filter(({ name }) => !only || name.includes(only));
}

/** Returns the hashes that a build's tests print, in one line. */
function hashes({ name, compiler, flags, emulator }) {
  say(`--- ${name}`);
  // The build type has no name, so that no flags come in but those that are asked for.
  const folder = buildWithCmake(
    `determinism/${name}`,
    {
      CMAKE_BUILD_TYPE: "None",
      CMAKE_CXX_COMPILER: compiler,
      CMAKE_CXX_FLAGS: flags,
      APOLLONIUS_WERROR: "ON",
    },
    { target: "determinism_tests" },
  );
  const [program, ...args] = [
    ...emulator,
    path.join(folder, "determinism_tests"),
    "--gtest_filter=*Determinism*",
  ];
  const { stdout, status, error } = spawnSync(program, args, { encoding: "utf8" });
  if (error) throw new SetUpError(`${name}: ${error.message}`);
  if (status !== 0) process.stdout.write(stdout);
  const found = stdout
    .split("\n")
    .filter((line) => /^(values|raw|geometry) +0x/.test(line))
    .map((line) => line.replace(/ +/, " "));
  return { name, status, line: found.join("  ") };
}

export function checkDeterminism() {
  const results = configurations(process.env.APOLLONIUS_DETERMINISM).map(hashes);
  for (const { name, status, line } of results)
    console.log(`${name.padEnd(24)} ${line}${status === 0 ? "" : "   FAILED"}`);
  const failed = results.filter(
    ({ status, line }) => status !== 0 || line.split("  ").length !== 3,
  );
  if (failed.length > 0)
    throw new SetUpError(`${failed.length} of ${results.length} builds failed`);
  const different = new Set(results.map(({ line }) => line)).size;
  if (different !== 1)
    throw new SetUpError(`${different} different answers of ${results.length} builds`);
  return `the same hashes from ${results.length} builds`;
}
