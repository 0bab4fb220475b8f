// Fuzzing: builds the targets with clang's libFuzzer, AddressSanitizer and
// UndefinedBehaviorSanitizer, and runs them in turn, a slice of time each, from the corpus in
// tests/fuzz/corpus.tar.gz and what earlier runs have added to it.
//
//   npm run fuzz -- --minutes 60                     all targets, for an hour in all
//   npm run fuzz -- --minutes 5 --target geometry    those whose name has that in it (several: with
//                                                    commas)
//   npm run fuzz -- --minutes 60 --jobs 2            two at a time, if need be of one target
//   npm run fuzz -- --merge                          no run: makes tests/fuzz/corpus.tar.gz of all
//                                                    that was found, minimised
//
// It can be stopped at any time; the table is printed then, too. A finding is an input that ends a
// target; it is kept in build/fuzz/findings with the target's output, and the run ends with 1.
// Executions are added up in docs/figures.json, over all states of src/: a finding, once its cause
// is mended, is a test, and no reason to count from zero.
import { spawn } from "node:child_process";
import { createHash } from "node:crypto";
import {
  cpSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { ensureBoost } from "../../tools/toolchain/boost.mjs";
import { ensureFuzzingClang } from "../../tools/toolchain/clang.mjs";
import { buildWithCmake } from "../../tools/toolchain/cmake.mjs";
import { root } from "../../tools/toolchain/folders.mjs";
import { withBuildLock } from "../../tools/toolchain/lock.mjs";
import { ensureNativeTools } from "../../tools/toolchain/native.mjs";
import { capture, SetUpError } from "../../tools/toolchain/process.mjs";
import { main } from "../../tools/toolchain/setup.mjs";
import { addToFigures, printTable } from "./totals.mjs";

const home = path.join(root, "build", "fuzz");
const findings = path.join(home, "findings");
const archive = path.join(root, "tests", "fuzz", "corpus.tar.gz");
const seeds = path.join(home, "program", "corpus"); // where CMake unpacks it
const sliceSeconds = 600; // each begins with reading the corpus, which is not counted
const mostOfCorpus = 100;

/** Longest inputs: the number of bytes that a target reads. */
const lengths = {
  operations_fuzz: 512,
  snapshot_fuzz: 4096,
  predicates_fuzz: 256,
  geometry_fuzz: 256,
  queries_fuzz: 256,
  regions_fuzz: 320,
  sphere_fuzz: 512,
};

const names = () =>
  readdirSync(path.join(root, "tests", "fuzz"))
    .filter((file) => file.endsWith("_fuzz.cpp"))
    .map((file) => file.slice(0, -4))
    .sort();

async function build(targets) {
  ensureNativeTools();
  ensureBoost();
  const settings = {
    CMAKE_BUILD_TYPE: "Release",
    APOLLONIUS_FUZZ: "ON",
    CMAKE_CXX_COMPILER: ensureFuzzingClang(),
  };
  return withBuildLock(() =>
    targets.map((target) => buildWithCmake("fuzz/program", settings, { target })).at(-1),
  );
}

/** The folders from which a target starts; into the first it puts its new inputs. */
function corpora(target) {
  const mine = path.join(home, "corpus", target);
  mkdirSync(mine, { recursive: true });
  const others = [path.join(seeds, target)];
  if (target === "snapshot_fuzz") others.push(path.join(root, "tests", "data", "snapshots"));
  return [mine, ...others.filter((folder) => existsSync(folder))];
}

const running = new Set();

/** Runs a program, its output in a string; interrupts it after this many seconds. */
function run(program, args, { seconds } = {}) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, { stdio: ["ignore", "pipe", "pipe"] });
    running.add(child);
    let output = "",
      isInterrupted = false;
    const timer =
      seconds &&
      setTimeout(() => {
        isInterrupted = true;
        child.kill("SIGINT");
      }, 1000 * seconds);
    for (const stream of [child.stdout, child.stderr])
      stream.on("data", (data) => (output = (output + data).slice(-200_000)));
    child.on("error", reject);
    child.on("close", (code) => {
      running.delete(child);
      clearTimeout(timer);
      resolve({ code, output, isInterrupted });
    });
  });
}

/** Runs one slice; returns its results. */
async function slice(folder, target, seconds) {
  const start = performance.now();
  // At the lowest priority, as it is not urgent.
  // (libFuzzer looks at the time only when it has read the corpus, which on a busy machine takes
  // minutes.)
  const { code, output, isInterrupted } = await run(
    "nice",
    [
      "-n",
      "19",
      path.join(folder, target),
      `-max_total_time=${seconds}`,
      `-max_len=${lengths[target] ?? 512}`,
      "-len_control=0",
      "-print_final_stats=1",
      "-timeout=300",
      "-report_slow_units=300",
      "-rss_limit_mb=4096",
      `-artifact_prefix=${path.join(findings, `${target}-`)}`,
      ...corpora(target),
    ],
    { seconds: seconds + 20 },
  );
  const number = (pattern) => Number([...output.matchAll(pattern)].at(-1)?.[1] ?? 0);
  const artifact = /Test unit written to (\S+)/.exec(output)?.[1];
  const isFinding = artifact !== undefined || (code !== 0 && !isStopped && !isInterrupted);
  if (isFinding)
    writeFileSync(`${artifact ?? path.join(findings, `${target}-${Date.now()}`)}.log`, output);
  return {
    executions: number(/number_of_executed_units:\s+(\d+)/g) || number(/^#(\d+)/gm),
    seconds: (performance.now() - start) / 1000,
    coverage: number(/ cov: (\d+)/g),
    findings: isFinding ? [artifact ?? `${target} ended with ${code}`] : [],
  };
}

let isStopped = false;

/**
 * Keeps `jobs` slices running until the time is over, always of the target that has had the least
 * time. (Several slices of one target read, when they begin, inputs that others have found.)
 */
async function fuzz(folder, targets, minutes, jobs) {
  mkdirSync(findings, { recursive: true });
  const end = performance.now() + minutes * 60_000;
  const done = Object.fromEntries(
    targets.map((target) => [target, { executions: 0, seconds: 0, coverage: 0, findings: [] }]),
  );
  const busy = Object.fromEntries(targets.map((target) => [target, 0])); // slices
  const longest = Math.max(5, Math.min(sliceSeconds, (minutes * 60 * jobs) / targets.length));
  const timeOf = (target) => done[target].seconds + busy[target] * longest;
  const work = async () => {
    for (;;) {
      const left = (end - performance.now()) / 1000;
      if (isStopped || left < 2) return;
      const [target] = [...targets].sort((a, b) => timeOf(a) - timeOf(b));
      ++busy[target];
      const result = await slice(folder, target, Math.ceil(Math.min(longest, left)));
      --busy[target];
      addToFigures(target, result);
      const sum = done[target];
      sum.executions += result.executions;
      sum.seconds += result.seconds;
      sum.coverage = Math.max(sum.coverage, result.coverage);
      sum.findings.push(...result.findings);
      for (const finding of result.findings) console.log(`FINDING: ${finding}`);
    }
  };
  await Promise.all(Array.from({ length: jobs }, work));
  return done;
}

/**
 * A target's seeds become the fewest inputs that reach as much as all do; of many, the shortest.
 */
async function merge(folder, target) {
  const kept = path.join(home, "merged", target);
  rmSync(kept, { recursive: true, force: true });
  mkdirSync(kept, { recursive: true });
  const { code, output } = await run(path.join(folder, target), [
    "-merge=1",
    `-max_len=${lengths[target] ?? 512}`,
    "-timeout=300",
    kept,
    ...corpora(target),
  ]);
  if (code !== 0) throw new SetUpError(output);
  const files = readdirSync(kept)
    .map((file) => ({ file, bytes: readFileSync(path.join(kept, file)) }))
    .sort((a, b) => a.bytes.length - b.bytes.length || Buffer.compare(a.bytes, b.bytes));
  // Evenly from short to long.
  const step = Math.max(1, files.length / mostOfCorpus);
  const chosen = Array.from(
    { length: Math.min(files.length, mostOfCorpus) },
    (_, k) => files[Math.floor(k * step)],
  );
  const place = path.join(seeds, target);
  rmSync(place, { recursive: true, force: true });
  mkdirSync(place, { recursive: true });
  for (const { bytes } of chosen)
    writeFileSync(
      path.join(place, createHash("sha1").update(bytes).digest("hex").slice(0, 16)),
      bytes,
    );
  const size = chosen.reduce((sum, { bytes }) => sum + bytes.length, 0);
  console.log(
    `${target}: ${chosen.length} of ${files.length} inputs, ${(size / 1024).toFixed(0)} KB`,
  );
}

/** Writes the seeds of all targets, the same bytes for the same seeds. */
function pack() {
  const files = readdirSync(seeds, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => path.relative(seeds, path.join(entry.parentPath ?? entry.path, entry.name)))
    .sort();
  const list = path.join(home, "seeds.txt");
  writeFileSync(list, files.join("\n"));
  const made = ["-E", "tar", "czf", archive, "--format=gnutar", "--mtime=2000-01-01 00:00:00 UTC"];
  capture("cmake", [...made, `--files-from=${list}`], { cwd: seeds });
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  await main(async () => {
    const { values } = parseArgs({
      options: {
        minutes: { type: "string", default: "10" },
        target: { type: "string", default: "" },
        jobs: { type: "string", default: "1" },
        merge: { type: "boolean", default: false },
      },
    });
    const minutes = Number(values.minutes),
      jobs = Number(values.jobs);
    const targets = names().filter((name) =>
      values.target.split(",").some((part) => name.includes(part)),
    );
    if (!(minutes > 0) || !Number.isInteger(jobs) || jobs < 1)
      throw new SetUpError("--minutes and --jobs take numbers above 0");
    if (targets.length === 0)
      throw new SetUpError(`no target ${values.target}: expected some of ${names().join(", ")}`);
    const folder = await build(targets);
    for (const signal of ["SIGINT", "SIGTERM"]) {
      process.on(signal, () => {
        isStopped = true;
        for (const child of running) child.kill("SIGINT"); // libFuzzer says its figures and ends
      });
    }
    // A copy is run, so that a build beside it does no harm.
    const copy = path.join(home, "running", String(process.pid));
    mkdirSync(copy, { recursive: true });
    for (const target of targets) cpSync(path.join(folder, target), path.join(copy, target));
    try {
      if (values.merge) {
        for (const target of targets) await merge(copy, target);
        pack();
        return;
      }
      const done = await fuzz(copy, targets, minutes, jobs);
      printTable(done);
      if (Object.values(done).some((target) => target.findings.length > 0)) process.exitCode = 1;
    } finally {
      rmSync(copy, { recursive: true, force: true });
    }
  });
}
