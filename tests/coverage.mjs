// npm run coverage: which lines and branches of src/ the native tests run, by folder; and those
// that they do not, each with its reason.
//
// Clang's source-based coverage. Without the shadow check: with it every exact stage runs on
// every input, whether or not a filter leaves anything to it, and half of src/predicate would be
// covered without being tested. A line that only a test's own direct call reaches (tests/predicate
// calls each stage) counts, because that is how stages are tested.
//
// A branch is one outcome of one condition; what several instances of a template run is added up.
// A line that stays uncovered has its reason in tests/check/uncovered.json, found by its text; a
// line without one is printed. A reason that is no longer needed makes the command fail. The tests
// themselves do not count. A run writes docs/figures.json.
//
//   npm run coverage -- --all      also prints lines and branches that have a reason
//   npm run coverage -- --reuse    reads the counts of the last run
import { mkdirSync, readFileSync, readdirSync, rmSync } from "node:fs";
import path from "node:path";
import { parseArgs } from "node:util";
import { recordFigures } from "../tools/figures.mjs";
import { ensureBoost } from "../tools/toolchain/boost.mjs";
import { buildWithCmake } from "../tools/toolchain/cmake.mjs";
import { root } from "../tools/toolchain/folders.mjs";
import { withBuildLock } from "../tools/toolchain/lock.mjs";
import { ensureClang, ensureCoverageTools, ensureNativeTools } from "../tools/toolchain/native.mjs";
import { capture } from "../tools/toolchain/process.mjs";
import { main } from "../tools/toolchain/setup.mjs";
import { programsIn, runPrograms } from "./programs.mjs";

const { values: options } = parseArgs({
  options: { all: { type: "boolean" }, reuse: { type: "boolean" } },
});

/** Runs all test programs. Throws if a test fails: lines after the failure would be uncovered. */
async function runAll(folder, profiles) {
  rmSync(profiles, { recursive: true, force: true });
  mkdirSync(profiles, { recursive: true });
  await runPrograms(folder, {
    envOf: (program, part) => ({
      LLVM_PROFILE_FILE: path.join(profiles, `${program}.${part}.profraw`),
    }),
  });
}

/** Line numbers with their counts, by file, from an lcov report. */
function linesOf(lcov) {
  const lines = {};
  let own;
  for (const row of lcov.split("\n")) {
    if (row.startsWith("SF:")) own = lines[path.relative(root, row.slice(3))] ??= new Map();
    const found = /^DA:(\d+),(\d+)/.exec(row);
    if (found) own.set(Number(found[1]), (own.get(Number(found[1])) ?? 0) + Number(found[2]));
  }
  return lines;
}

/**
 * How often the code at a place has run; segments are [line, column, count, hasCount, ...] in
 * order.
 */
function countAt(segments, line, column) {
  let count = 0;
  for (const [l, c, n, hasCount] of segments) {
    if (l > line || (l === line && c > column)) break;
    count = hasCount ? n : 0;
  }
  return count;
}

/**
 * Conditions as [line, column, how often true, how often false]: template instances together,
 * constant conditions left out.
 */
function conditionsOf({ branches, segments }) {
  const merged = new Map();
  for (const [line, column, endLine, endColumn, yes, no] of branches) {
    const key = [line, column, endLine, endColumn].join();
    const before = merged.get(key) ?? [line, column, 0, 0];
    merged.set(key, [line, column, before[2] + yes, before[3] + no]);
  }
  // Neither true nor false although it has run: known when it was compiled.
  return [...merged.values()].filter(
    ([line, column, yes, no]) => yes + no > 0 || countAt(segments, line, column) === 0,
  );
}

function measure(folder, programs, profiles) {
  const [profdata, cov] = ensureCoverageTools();
  const merged = path.join(profiles, "all.profdata");
  const raw = readdirSync(profiles)
    .filter((name) => name.endsWith(".profraw"))
    .map((name) => path.join(profiles, name));
  capture(profdata, ["merge", "-sparse", ...raw, "-o", merged]);
  const objects = programs.flatMap((program, k) => [
    ...(k > 0 ? ["-object"] : []),
    path.join(folder, program),
  ]);
  const common = [
    "export",
    `-instr-profile=${merged}`,
    "-ignore-filename-regex=/(tests|googletest|boost|include|bench)/",
    ...objects,
  ];
  const lines = linesOf(capture(cov, [...common, "-format=lcov"]));
  const [{ files }] = JSON.parse(
    capture(cov, [...common, "-skip-functions", "-skip-expansions"]),
  ).data;
  return files
    .map((file) => ({ name: path.relative(root, file.filename), conditions: conditionsOf(file) }))
    .filter(({ name }) => name.startsWith("src/"))
    .map(({ name, conditions }) => ({ name, conditions, lines: lines[name] }))
    .sort((a, b) => a.name.localeCompare(b.name));
}

/** Returns the parts of a file that did not run: [line, what, column of the condition]. */
function uncoveredOf({ lines, conditions }) {
  const found = [...lines].filter(([, count]) => count === 0).map(([line]) => [line, "not run"]);
  for (const [line, column, yes, no] of conditions) {
    if (lines.get(line) === 0) continue; // said already
    if (yes === 0) found.push([line, "never true", column]);
    if (no === 0) found.push([line, "never false", column]);
  }
  return found.sort((a, b) => a[0] - b[0]);
}

const percent = (part, whole) => (whole === 0 ? "–" : `${((100 * part) / whole).toFixed(2)} %`);

/** Prints shares by folder; returns them, in percent. */
function table(files) {
  const rows = new Map();
  const add = (key, { lines, conditions }) => {
    const row = rows.get(key) ?? rows.set(key, [0, 0, 0, 0]).get(key);
    row[0] += [...lines.values()].filter((count) => count > 0).length;
    row[1] += lines.size;
    for (const [, , yes, no] of conditions) row[2] += (yes > 0) + (no > 0);
    row[3] += 2 * conditions.length;
  };
  for (const file of files) {
    add(file.name.split("/").length > 2 ? path.dirname(file.name) : "src", file);
    add("all", file);
  }
  const figures = {};
  for (const [name, [lines, allLines, outcomes, allOutcomes]] of rows) {
    figures[path.basename(name)] = {
      lines: (100 * lines) / allLines,
      branches: allOutcomes === 0 ? 100 : (100 * outcomes) / allOutcomes,
    };
    const ofLines = `${percent(lines, allLines).padStart(8)} (${lines} of ${allLines})`;
    const ofBranches = `${percent(outcomes, allOutcomes)} (${outcomes} of ${allOutcomes})`;
    console.log(`${name.padEnd(14)} lines ${ofLines.padEnd(29)}branches ${ofBranches}`);
  }
  return figures;
}

/** Prints uncovered places; returns their number, and the number of reasons that are not needed. */
function list(files) {
  const reasons = JSON.parse(readFileSync(path.join(root, "tests/check/uncovered.json"), "utf8"));
  const used = new Set();
  let explained = 0,
    unexplained = 0;
  for (const file of files) {
    const text = readFileSync(path.join(root, file.name), "utf8").split("\n");
    for (const [line, what, column] of uncoveredOf(file)) {
      const source = text[line - 1].trim();
      const reason = reasons.find(
        (entry) => entry.file === file.name && entry.lines.includes(source),
      );
      if (reason) used.add(reason).add(`${file.name} ${source}`);
      reason ? ++explained : ++unexplained;
      if (!reason || options.all)
        console.log(
          `${file.name}:${line}${column ? `:${column}` : ""}: ${what} | ${source}` +
            (reason ? `   # ${reason.why}` : ""),
        );
    }
  }
  const stale = reasons.flatMap(({ file, lines }) =>
    lines.filter((line) => !used.has(`${file} ${line}`)).map((line) => `${file}: ${line}`),
  );
  for (const line of stale) console.log(`is covered, or is not there any more: ${line}`);
  console.log(
    `${explained} uncovered with a reason (tests/check/uncovered.json), ${unexplained} without, ` +
      `${stale.length} reasons for nothing`,
  );
  return { explained, unexplained, stale: stale.length };
}

await main(async () => {
  ensureNativeTools();
  ensureBoost();
  const settings = {
    CMAKE_BUILD_TYPE: "None",
    CMAKE_CXX_COMPILER: ensureClang(),
    APOLLONIUS_WERROR: "ON",
    CMAKE_CXX_FLAGS: "-O1 -DNDEBUG -fprofile-instr-generate -fcoverage-mapping",
  };
  const folder = options.reuse
    ? path.join(root, "build/coverage")
    : await withBuildLock(() => buildWithCmake("coverage", settings));
  const programs = programsIn(folder);
  const profiles = path.join(folder, "profiles");
  if (!options.reuse) await runAll(folder, profiles);
  const files = measure(folder, programs, profiles);
  const { explained, unexplained, stale } = list(files);
  const byFolder = table(files);
  if (!options.reuse) recordFigures("coverage", { ...byFolder, explained, unexplained });
  if (stale > 0) process.exitCode = 1;
});
