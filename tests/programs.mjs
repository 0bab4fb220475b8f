// Runs the native test programs of a build folder by themselves, each in parts side by side: CTest
// would start a process for each of two thousand tests, most of which take a millisecond.
import { spawn } from "node:child_process";
import { readdirSync } from "node:fs";
import path from "node:path";
import { jobs } from "../tools/toolchain/cmake.mjs";
import { root } from "../tools/toolchain/folders.mjs";
import { SetUpError } from "../tools/toolchain/process.mjs";

const kParts = 8; // parts of a program: enough that no processor waits long for the last one

export const programsIn = (folder) =>
  readdirSync(folder).filter((file) => file.endsWith("_tests") && file !== "determinism_tests");

/** Runs a program; resolves to its exit code and what it has printed. */
function run(program, filter, env) {
  return new Promise((resolve, reject) => {
    let output = "";
    const child = spawn(program, ["--gtest_brief=1", `--gtest_filter=${filter}`], {
      cwd: root,
      env: { ...process.env, ...env },
      stdio: ["ignore", "pipe", "pipe"],
    });
    for (const stream of [child.stdout, child.stderr])
      stream.on("data", (data) => (output += data));
    child.on("error", reject);
    child.on("close", (code, signal) => resolve({ code: code ?? signal, output }));
  });
}

/**
 * Runs programs, all tests of all of them unless `filters` says otherwise, and prints the output of
 * those that fail. Returns how many tests passed and were skipped; throws if one failed or a
 * program crashed.
 * @param {string} folder
 * @param {{ filters?: Map<string, string>, envOf?: (program: string, part: number) => object }}
 *   [options] GoogleTest's filter by program; more of the environment
 */
export async function runPrograms(folder, { filters, envOf = () => ({}) } = {}) {
  filters ??= new Map(programsIn(folder).map((program) => [program, "*"]));
  const queue = [...filters].flatMap(([program, filter]) =>
    Array.from({ length: kParts }, (_, part) => ({ program, filter, part })),
  );
  const sum = { passed: 0, failed: 0, skipped: 0 };
  const failures = []; // names of tests, and parts of programs that crashed
  const worker = async () => {
    for (let next = queue.shift(); next !== undefined; next = queue.shift()) {
      const { program, filter, part } = next;
      const { code, output } = await run(path.join(folder, program), filter, {
        GTEST_TOTAL_SHARDS: String(kParts),
        GTEST_SHARD_INDEX: String(part),
        ...envOf(program, part),
      });
      const count = (what) =>
        Number(new RegExp(`^\\[  ${what.padEnd(8)}\\] (\\d+) test`, "m").exec(output)?.[1] ?? 0);
      sum.passed += count("PASSED");
      sum.skipped += count("SKIPPED");
      if (code === 0) continue;
      console.log(output);
      const failed = [...output.matchAll(/^\[ {2}FAILED {2}\] (\w\S*\.\S+)/gm)].map(
        ([, test]) => test,
      );
      sum.failed += new Set(failed).size;
      failures.push(...new Set(failed));
      if (failed.length === 0) failures.push(`${program}, part ${part}, ended with ${code}`);
    }
  };
  await Promise.all(Array.from({ length: Number(jobs) }, worker));
  const line = `${sum.passed} passed, ${sum.failed} failed, ${sum.skipped} skipped`;
  if (failures.length > 0) throw new SetUpError([line, ...failures].join("\n"));
  return line;
}
