// The test programs of the switched build: how long each test takes and which mutants it comes by,
// and whether tests notice a mutant.
import { spawn } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { createInterface } from "node:readline";

const kLeastSeconds = 20,
  kPatience = 10; // a test hangs after this many seconds and times its own time
const kMemory = 4 << 20; // kilobytes: a mutant must not take the machine's
// seconds: quick tests are tried first, each class in one process a program
const kClasses = [0.1, 1, 10];

/**
 * Runs some tests of a program; calls back with each that passes, and its seconds, null if it was
 * skipped. Resolves to what went wrong, or null.
 */
function runTests({ program, tests, env, limitOf, passed }) {
  return new Promise((resolve) => {
    const args = [
      "-c",
      `ulimit -c 0; ulimit -v ${kMemory}; exec "$0" "$@"`,
      program,
      "--gtest_fail_fast",
      "--gtest_color=no",
      `--gtest_filter=${tests.join(":")}`,
    ];
    const child = spawn("bash", args, {
      env: { ...process.env, ...env },
      stdio: ["ignore", "pipe", "ignore"],
    });
    let current = null,
      failed = null,
      timer,
      hangs = false;
    const watch = (seconds) => {
      clearTimeout(timer);
      timer = setTimeout(() => {
        hangs = true;
        child.kill("SIGKILL");
      }, 1000 * seconds);
    };
    watch(kLeastSeconds);
    createInterface({ input: child.stdout }).on("line", (line) => {
      const [, state, name, milliseconds] =
        /^\[ *(RUN|OK|FAILED|SKIPPED) *\] ([^ ,]+)(?:,.*)?(?: \((\d+) ms\))?/.exec(line) ?? [];
      if (state === undefined || !name.includes(".")) return;
      if (state === "RUN") {
        current = name;
        watch(limitOf(name));
      }
      if (state === "FAILED") failed ??= name;
      if (state === "OK") passed?.(name, Number(milliseconds) / 1000);
      if (state === "SKIPPED") passed?.(name, null);
      if (state !== "RUN") current = null;
    });
    child.on("close", (code, signal) => {
      clearTimeout(timer);
      const end = signal ?? (code > 128 ? `signal ${code - 128}` : code);
      if (hangs) resolve(`${current ?? "the program"} hangs`);
      else if (failed !== null) resolve(failed);
      else resolve(code === 0 ? null : `${current ?? "the program"} ends with ${end}`);
    });
  });
}

function listTests(program) {
  return new Promise((resolve) => {
    const child = spawn(program, ["--gtest_list_tests"], { stdio: ["ignore", "pipe", "ignore"] });
    const tests = [];
    let suite = "";
    createInterface({ input: child.stdout }).on("line", (line) => {
      const name = line.replace(/ *#.*/, "");
      if (/^\S+\.$/.test(name)) suite = name;
      else if (/^ {2}\S/.test(name)) tests.push(suite + name.trim());
    });
    child.on("close", () => resolve(tests.filter((test) => !/(^|\.|\/)DISABLED_/.test(test))));
  });
}

/** Runs `work` on all items, `jobs` at a time. */
export async function inParallel(items, jobs, work) {
  const rest = [...items];
  await Promise.all(
    Array.from({ length: jobs }, async () => {
      while (rest.length > 0) await work(rest.shift());
    }),
  );
}

export class Suite {
  /** Keeps measurements in the file `measured` for as long as a program does not change. */
  constructor(measured, jobs) {
    this.measured = measured;
    this.jobs = jobs;
    this.tests = []; // { program, name, seconds, reaches }
  }

  /**
   * Runs each test of the programs in a folder by itself, without a mutant; or those named only.
   * Tests that skip themselves are no part of the suite, and those that take longer than `longest`
   * seconds are left for another time. Returns the names of those that skip, by program.
   */
  async measure(folder, longest, only) {
    const kept = existsSync(this.measured) ? JSON.parse(readFileSync(this.measured, "utf8")) : {};
    const skipped = {};
    let written = 0;
    const save = () => {
      writeFileSync(this.measured, JSON.stringify(kept));
      written = Date.now();
    };
    for (const name of readdirSync(folder).filter(
      (file) => file.endsWith("_tests") && (only === undefined || only[file]),
    )) {
      const program = path.join(folder, name);
      const key = createHash("sha256").update(readFileSync(program)).digest("hex").slice(0, 16);
      if (kept[program]?.key !== key) kept[program] = { key, tests: {} };
      const { tests } = kept[program];
      const names = only?.[name] ?? (await listTests(program));
      await inParallel(
        names.filter((test) => tests[test] === undefined),
        this.jobs,
        async (test) => {
          const reached = path.join(folder, `reached_${process.pid}_${test.replace(/\W/g, "_")}`);
          let seconds = 0;
          const wrong = await runTests({
            program,
            tests: [test],
            env: { APOLLONIUS_REACHED: reached },
            limitOf: () => Math.min(1200, 3 + 4 * longest),
            passed: (_, time) => {
              seconds = time;
            },
          });
          if (wrong?.endsWith("hangs") && longest < Infinity) return;
          if (wrong !== null) throw new Error(`without any mutant: ${wrong} (${name}, ${test})`);
          // A program that has nothing of the library in it (tests of the tests) writes none.
          const reaches = existsSync(reached) ? readFileSync(reached, "utf8") : "";
          tests[test] = { seconds, reaches: reaches.split("\n").filter(Boolean).map(Number) };
          rmSync(reached, { force: true });
          if (Date.now() > written + 5000) save();
        },
      );
      save();
      for (const [test, { seconds, reaches }] of Object.entries(tests)) {
        if (seconds === null) {
          skipped[name] ??= [];
          skipped[name].push(test);
        } else this.tests.push({ program, name: test, seconds, reaches: new Set(reaches) });
      }
    }
    return skipped;
  }

  /**
   * Returns the name of a test that notices the mutant, or null. Only tests that come by it are
   * run, of no more than `longest` seconds each, quick ones first, and those of `own` before
   * others.
   */
  async noticedBy(number, own, longest) {
    // else at most a death test reaches it, whose child process does not report that
    const isReached = this.tests.some(({ reaches }) => reaches.has(number));
    const tests = this.tests.filter(
      ({ reaches, seconds, program }) =>
        (isReached ? reaches.has(number) : path.basename(program).startsWith(own)) &&
        seconds <= longest,
    );
    const programs = [...new Set(tests.map(({ program }) => program))].sort(
      (a, b) => path.basename(b).startsWith(own) - path.basename(a).startsWith(own),
    );
    let least = 0;
    for (const most of [...kClasses, Infinity]) {
      for (const program of programs) {
        const some = tests.filter(
          (test) => test.program === program && test.seconds >= least && test.seconds < most,
        );
        const secondsOf = new Map(some.map(({ name, seconds }) => [name, seconds]));
        const groups =
          most === Infinity ? some.map((test) => [test]) : some.length > 0 ? [some] : [];
        for (const group of groups) {
          const wrong = await runTests({
            program,
            tests: group.map(({ name }) => name),
            env: { APOLLONIUS_MUTANT: String(number) },
            limitOf: (name) => kLeastSeconds + kPatience * (secondsOf.get(name) ?? 1),
          });
          if (wrong !== null) return wrong;
        }
      }
      least = most;
    }
    return null;
  }
}
