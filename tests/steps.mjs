// Shared by the commands of named steps (`npm test`, `npm run check`): running test programs, and
// steps one after another. All steps run, also after one that failed; a table at the end says what
// came of each.
import { spawn } from "node:child_process";
import { createInterface } from "node:readline";
import { jobs } from "../tools/toolchain/cmake.mjs";
import { root } from "../tools/toolchain/folders.mjs";
import { say, SetUpError } from "../tools/toolchain/process.mjs";
import { main } from "../tools/toolchain/setup.mjs";

/** A line with which Jest, CTest or GoogleTest names a test that failed. */
const failure = /^\s*● .+ › |\*\*\*(Failed|Timeout|Exception)|^\[ {2}FAILED {2}\] \w+\.\w+/;
/** Lines that are kept of each failure, from the name on, and of all together. */
const linesOfFailure = 8;
const linesOfFailures = 80;

/**
 * Runs a program and shows its output without lines that match `boring`; returns the last line that
 * matches `summary`. If it fails, throws an error with that line and the failures, so that they are
 * also at the end of a long output (of CI, say).
 */
export function runTests(program, args, { summary, boring, env }) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, {
      cwd: root,
      env: { ...process.env, ...env },
      stdio: ["ignore", "pipe", "pipe"],
    });
    let last = "no summary";
    const failures = [];
    let listing = 0; // lines that still belong to the last failure
    for (const [stream, sink] of [
      [child.stdout, process.stdout],
      [child.stderr, process.stderr],
    ]) {
      createInterface({ input: stream }).on("line", (line) => {
        if (summary.test(line)) last = line.trim();
        if (!boring?.test(line)) sink.write(`${line}\n`);
        if (failure.test(line)) listing = linesOfFailure;
        if (listing-- > 0 && failures.length < linesOfFailures) failures.push(line);
      });
    }
    child.on("error", reject);
    child.on("close", (code) => {
      if (code === 0) resolve(last);
      else reject(new SetUpError([last, ...failures].join("\n")));
    });
  });
}

/** All tests of a build folder, or those whose name matches; refused if there is none. */
export function ctest(folder, { env, name, orNone = false } = {}) {
  const args = [
    "--test-dir",
    folder,
    "--output-on-failure",
    `--no-tests=${orNone ? "ignore" : "error"}`,
    ...(name === undefined ? [] : ["-R", name]),
    "--parallel",
    jobs,
  ];
  const boring = /^\s+Start +\d+: |Passed +0\.\d+ sec$/;
  return runTests("ctest", args, { summary: /tests passed, \d+ tests? failed/, boring, env });
}

/** Projects of tests/jest.config.mjs, or their tests whose names match; `more` goes to Jest. */
export function jest(projects, { env, name, more = [] } = {}) {
  const args = [
    "--experimental-vm-modules",
    "node_modules/jest/bin/jest.js",
    "--config",
    "tests/jest.config.mjs",
    "--maxWorkers",
    jobs, // Jest itself would leave one processor alone
    "--selectProjects",
    ...projects,
    ...(name === undefined ? [] : ["-t", name]),
    ...more,
  ];
  return runTests(process.execPath, args, {
    summary: /^Tests: /,
    env: { NODE_NO_WARNINGS: "1", ...env },
  });
}

const secondsSince = (start) => `${((performance.now() - start) / 1000).toFixed(0)} s`;

/** Runs a step; resolves to whether it passed, and its line of the table. */
async function outcomeOf(name, step) {
  const start = performance.now();
  let text,
    passed = true;
  try {
    text = await step();
  } catch (error) {
    if (!(error instanceof SetUpError)) console.error(error);
    text = error.message;
    passed = false;
  }
  process.send?.(text); // to tests/side_by_side.mjs
  const result = passed ? text : `FAILED: ${text}`;
  return { passed, line: `${name.padEnd(12)} ${secondsSince(start).padStart(5)}   ${result}` };
}

/** Refuses names that no step has. */
export function checkNames(steps, wanted) {
  const unknown = wanted.find((name) => !(name in steps));
  if (unknown)
    throw new SetUpError(`unknown step ${unknown}: expected ${Object.keys(steps).join(", ")}`);
}

/**
 * Runs steps one after another, or lanes of them side by side; prints the table, and sets the exit
 * code.
 * @param {[name: string, step: () => Promise<string> | string][][]} lanes each step returns its
 * line of the table, or throws
 */
export async function runLanes(lanes) {
  const began = performance.now();
  const outcomes = [];
  await Promise.all(
    lanes.map(async (lane) => {
      for (const [name, step] of lane) {
        say(`=== ${name}`);
        outcomes.push(await outcomeOf(name, step));
      }
    }),
  );
  const passed = outcomes.every((outcome) => outcome.passed);
  const table = outcomes.map(({ line }) => line).join("\n");
  console.log(`\n${table}\n${passed ? "All passed" : "FAILED"} in ${secondsSince(began)}`);
  if (!passed) process.exitCode = 1;
}

/**
 * Runs the steps that are named on the command line, or all, one after another.
 * @param {Record<string, () => Promise<string> | string>} steps
 * @param {string[]} wanted
 */
export function runSteps(steps, wanted = process.argv.slice(2)) {
  return main(async () => {
    checkNames(steps, wanted);
    const names = wanted.length > 0 ? wanted : Object.keys(steps);
    await runLanes([names.map((name) => [name, steps[name]])]);
  });
}
