// Commands of named steps: `npm test`, `npm run check`. All steps run, also after one that failed;
// a table at the end says what came of each.
import { spawn } from "node:child_process";
import { createInterface } from "node:readline";
import { jobs } from "../tools/toolchain/cmake.mjs";
import { root } from "../tools/toolchain/folders.mjs";
import { say, SetUpError } from "../tools/toolchain/process.mjs";
import { main } from "../tools/toolchain/setup.mjs";

/**
 * Runs a program with its output shown, but for lines that match `boring`; returns the last line
 * that matches `summary`. Throws if it fails.
 */
export function runTests(program, args, { summary, boring, env }) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, {
      cwd: root,
      env: { ...process.env, ...env },
      stdio: ["ignore", "pipe", "pipe"],
    });
    let last = "no summary";
    for (const [stream, sink] of [
      [child.stdout, process.stdout],
      [child.stderr, process.stderr],
    ]) {
      createInterface({ input: stream }).on("line", (line) => {
        if (summary.test(line)) last = line.trim();
        if (!boring?.test(line)) sink.write(`${line}\n`);
      });
    }
    child.on("error", reject);
    child.on("close", (code) => (code === 0 ? resolve(last) : reject(new SetUpError(last))));
  });
}

/** All tests of a build folder, or those whose name matches. */
export function ctest(folder, { env, name } = {}) {
  const args = [
    "--test-dir",
    folder,
    "--output-on-failure",
    ...(name === undefined ? ["--no-tests=error"] : ["--no-tests=ignore", "-R", name]),
    "--parallel",
    jobs,
  ];
  const boring = /^\s+Start +\d+: |Passed +0\.\d+ sec$/;
  return runTests("ctest", args, { summary: /tests passed, \d+ tests? failed/, boring, env });
}

/** Projects of tests/jest.config.mjs, or their tests whose names match. */
export function jest(projects, { env, name } = {}) {
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
  ];
  return runTests(process.execPath, args, {
    summary: /^Tests: /,
    env: { NODE_NO_WARNINGS: "1", ...env },
  });
}

function secondsSince(start) {
  return `${((performance.now() - start) / 1000).toFixed(0)} s`;
}

/**
 * Runs the steps that are named on the command line, or all.
 * @param {Record<string, () => Promise<string> | string>} steps each returns its line of the table,
 * or throws
 * @param {string[]} wanted
 */
export function runSteps(steps, wanted = process.argv.slice(2)) {
  return main(async () => {
    const unknown = wanted.find((name) => !(name in steps));
    if (unknown)
      throw new SetUpError(`unknown step ${unknown}: expected ${Object.keys(steps).join(", ")}`);
    const width = Math.max(...Object.keys(steps).map((name) => name.length));
    const began = performance.now();
    const report = [];
    for (const name of wanted.length > 0 ? wanted : Object.keys(steps)) {
      say(`=== ${name}`);
      const start = performance.now();
      try {
        report.push(`${name.padEnd(width)} ${await steps[name]()}   (${secondsSince(start)})`);
      } catch (error) {
        if (!(error instanceof SetUpError)) console.error(error);
        report.push(`${name.padEnd(width)} FAILED: ${error.message}   (${secondsSince(start)})`);
        process.exitCode = 1;
      }
    }
    const result = process.exitCode ? "FAILED" : "All passed";
    console.log(`\n${report.join("\n")}\n${result} in ${secondsSince(began)}`);
  });
}
