// clang-tidy and cppcheck on the library and the bindings; headers are seen through the files that
// include them.
import { spawn } from "node:child_process";
import { mkdirSync, readFileSync, readdirSync } from "node:fs";
import path from "node:path";
import { configureWithCmake, jobs } from "../../tools/toolchain/cmake.mjs";
import { root } from "../../tools/toolchain/folders.mjs";
import { ensureClang, ensureClangTidy, ensureCppcheck } from "../../tools/toolchain/native.mjs";
import { run, say, SetUpError } from "../../tools/toolchain/process.mjs";

const sources = () =>
  readdirSync(path.join(root, "src"), { recursive: true })
    .filter((name) => name.endsWith(".cpp"))
    .map((name) => `src/${name}`)
    .sort();

/** Returns the output of a program, whatever its exit code. */
function output(program, args) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, { cwd: root, stdio: ["ignore", "pipe", "pipe"] });
    let text = "",
      errors = "";
    child.stdout.on("data", (chunk) => (text += chunk));
    child.stderr.on("data", (chunk) => (errors += chunk));
    child.on("error", reject);
    child.on("close", (code) =>
      code === 0 || text !== "" ? resolve(text) : reject(new SetUpError(`${program}: ${errors}`)),
    );
  });
}

/** Runs clang-tidy on each file; a finding in a header counts once. */
export async function tidy() {
  const program = ensureClangTidy();
  const folder = configureWithCmake("tidy", {
    CMAKE_CXX_COMPILER: ensureClang(),
    APOLLONIUS_TESTS: "OFF",
  });
  const queue = sources();
  const count = queue.length;
  const findings = new Set();
  const worker = async () => {
    for (let file = queue.shift(); file !== undefined; file = queue.shift()) {
      const text = await output(program, ["-p", folder, "--quiet", file]);
      for (const finding of text.split(/^(?=\S+:\d+:\d+: (?:warning|error): )/m)) {
        if (finding.trim() !== "" && !findings.has(finding))
          console.log(finding.trimEnd().replaceAll(`${root}/`, ""));
        findings.add(finding);
      }
    }
  };
  await Promise.all(Array.from({ length: Number(jobs) }, worker));
  findings.delete("");
  if (findings.size > 0) throw new SetUpError(`${findings.size} findings in ${count} files`);
  return `no findings in ${count} files`;
}

export function cppcheck() {
  const program = ensureCppcheck();
  const work = path.join(root, "build/cppcheck");
  mkdirSync(work, { recursive: true });
  const list = "tests/check/cppcheck.txt";
  say(
    `${
      readFileSync(path.join(root, list), "utf8")
        .split("\n")
        .filter((line) => /^\w/.test(line)).length
    } kinds of findings are left out: ${list}`,
  );
  // With a definition, what stands behind others is left out, so it is not for all.
  const declare = "-DEMSCRIPTEN_DECLARE_VAL_TYPE(name)=class name;";
  for (const what of [["src"], [declare, "wasm/bindings"]]) {
    run(
      program,
      [
        "--std=c++20",
        "--language=c++",
        "--enable=warning,performance,portability,style",
        "--error-exitcode=1",
        "--quiet",
        "-j",
        jobs,
        "-I",
        "src",
        `--suppressions-list=${list}`,
        `--cppcheck-build-dir=${work}`,
        "--template={file}:{line}: {id}: {message}",
        ...what,
      ],
      { cwd: root },
    );
  }
  return "no findings";
}
