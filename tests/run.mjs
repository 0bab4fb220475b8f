// npm test: sets up, builds, and runs everything.     npm test -- native wasm package web    runs some steps only
//
//   native    the C++ tests, natively, with every filtered predicate answer compared to the exact one
//   wasm      the same C++ tests as WebAssembly under Node
//   package  Jest on the package as `npm pack` makes it (in Node, in browsers, through bundlers), and on the rules about who may
//            include whom
//   web       Jest on the page in a real browser
import { spawn } from "node:child_process";
import { createInterface } from "node:readline";
import { buildPackage } from "../wasm/build.mjs";
import { ensureChromium, ensureFirefox } from "../wasm/toolchain/browser.mjs";
import { ensureBoost } from "../wasm/toolchain/boost.mjs";
import { buildWasmTests, buildWithCmake, jobs } from "../wasm/toolchain/cmake.mjs";
import { ensureEmscripten } from "../wasm/toolchain/emscripten.mjs";
import { root } from "../wasm/toolchain/folders.mjs";
import { withBuildLock } from "../wasm/toolchain/lock.mjs";
import { ensureNativeTools } from "../wasm/toolchain/native.mjs";
import { say, SetUpError } from "../wasm/toolchain/process.mjs";
import { main } from "../wasm/toolchain/setup.mjs";
import { installPacked } from "./wasm/support/install_packed.mjs";

/**
 * Runs a test runner with its output shown, but for lines that match `boring`; returns the last line that matches `summary`.
 * Throws if it fails.
 */
function runTests(program, args, { summary, boring, env }) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, { cwd: root, env: { ...process.env, ...env }, stdio: ["ignore", "pipe", "pipe"] });
    let last = "no summary";
    for (const [stream, sink] of [[child.stdout, process.stdout], [child.stderr, process.stderr]]) {
      createInterface({ input: stream }).on("line", (line) => {
        if (summary.test(line)) last = line.trim();
        if (!boring?.test(line)) sink.write(`${line}\n`);
      });
    }
    child.on("error", reject);
    child.on("close", (code) => (code === 0 ? resolve(last) : reject(new SetUpError(last))));
  });
}

function ctest(folder) {
  const args = ["--test-dir", folder, "--output-on-failure", "--no-tests=error", "--parallel", jobs];
  const boring = /^\s+Start +\d+: |Passed +0\.\d+ sec$/;
  return runTests("ctest", args, { summary: /tests passed, \d+ tests? failed/, boring });
}

function jest(projects, env = {}) {
  const args = ["--experimental-vm-modules", "node_modules/jest/bin/jest.js",
                "--config", "tests/jest.config.mjs", "--selectProjects", ...projects];
  return runTests(process.execPath, args, { summary: /^Tests: /, env: { NODE_NO_WARNINGS: "1", ...env } });
}

const steps = {
  async native() {
    ensureNativeTools();
    ensureBoost();
    const settings = { CMAKE_BUILD_TYPE: "Release", APOLLONIUS_SHADOW_CHECK: "ON" };
    return ctest(await withBuildLock(() => buildWithCmake("native", settings)));
  },
  async wasm() {
    ensureNativeTools();
    const emscripten = ensureEmscripten();
    ensureBoost();
    return ctest(await withBuildLock(() => buildWasmTests(emscripten)));
  },
  async package() {
    const browsers = { CHROMIUM: ensureChromium() ?? "", FIREFOX: ensureFirefox() ?? "" };
    await buildPackage();
    installPacked();
    const line = await jest(["package", "layers"], browsers);
    const missing = Object.keys(browsers).filter((name) => browsers[name] === "");
    return missing.length === 0 ? line : `${line}   WITHOUT ${missing.join(" AND ")}: install it, or set that variable to its path`;
  },
  async web() {
    const chromium = ensureChromium();
    if (chromium === null && process.env.CI) {
      throw new SetUpError("no browser: none is installed, and apt has no package `chromium` that could be installed");
    }
    await buildPackage();
    const line = await jest(["web"], { CHROMIUM: chromium ?? "" });
    return chromium ? line : `${line}   WITHOUT A BROWSER: install Chromium, or set CHROMIUM to its path`;
  },
};

function secondsSince(start) {
  return `${((performance.now() - start) / 1000).toFixed(0)} s`;
}

await main(async () => {
  const wanted = process.argv.slice(2);
  const unknown = wanted.find((name) => !(name in steps));
  if (unknown) throw new SetUpError(`unknown step ${unknown}: expected ${Object.keys(steps).join(", ")}`);
  const began = performance.now();
  const report = [];
  for (const name of wanted.length > 0 ? wanted : Object.keys(steps)) {
    say(`=== ${name}`);
    const start = performance.now();
    try {
      report.push(`${name.padEnd(8)} ${await steps[name]()}   (${secondsSince(start)})`);
    } catch (error) {
      if (!(error instanceof SetUpError)) console.error(error);
      report.push(`${name.padEnd(8)} FAILED: ${error.message}   (${secondsSince(start)})`);
      process.exitCode = 1;
    }
  }
  console.log(`\n${report.join("\n")}\n${process.exitCode ? "FAILED" : "All passed"} in ${secondsSince(began)}`);
});
