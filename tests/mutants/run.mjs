// Mutants: small changes to src/ that the tests must notice. Each is applied to a copy of the sources, built, and tried on the native tests
// until one fails (or hangs, or does not build: then it says so, as such a mutant is no good).
//
//   npm run mutants                        all of tests/mutants/mutants.json; hours on two cores
//   npm run mutants -- --from 20 --to 40   some of them
//   npm run mutants -- --only predicate    those of files whose path has that in it
//   npm run mutants -- --propose 150       prints so many new ones, spread over the files of src/: for a person to choose from
//
// A mutant is a file, one line of it, and what that line becomes. One with an `equivalent` (why no test can notice it) is left out. The report goes
// to build/mutants/report.json; results of earlier runs are kept for mutants and sources that have not changed.
import { spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { proposals } from "./propose.mjs";

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
const work = path.join(root, "build", "mutants");
const tree = path.join(work, "tree");
const reportFile = path.join(work, "report.json");
const jobs = String(availableParallelism());
const kSlowestTest = 900;  // seconds; the unchanged programs take a fraction of it

const { values: options } = parseArgs({
  options: { from: { type: "string", default: "0" }, to: { type: "string" }, only: { type: "string", default: "" }, propose: { type: "string" } },
});

if (options.propose) {
  console.log(JSON.stringify(proposals(root, Number(options.propose)), null, 1));
  process.exit();
}

const all = JSON.parse(readFileSync(path.join(root, "tests/mutants/mutants.json"), "utf8"));
const digest = (text) => createHash("sha256").update(text).digest("hex").slice(0, 16);

/** The file with the mutant's line changed; throws unless that line is there once. */
function mutated({ file, line, becomes }) {
  const lines = readFileSync(path.join(root, file), "utf8").split("\n");
  const places = lines.flatMap((text, k) => (text.trim() === line ? [k] : []));
  if (places.length !== 1) throw new Error(`${file} has ${places.length} lines "${line}"`);
  const [k] = places;
  lines[k] = lines[k].replace(line, () => becomes);
  return lines.join("\n");
}

const run = (program, args, seconds) =>
  spawnSync(program, args, { cwd: tree, encoding: "utf8", timeout: 1000 * seconds, maxBuffer: 1 << 28, killSignal: "SIGKILL" });

/** A copy of what is built, with a build folder of its own that later mutants share. */
function prepare() {
  mkdirSync(tree, { recursive: true });
  for (const name of ["CMakeLists.txt", "src", "tests", "wasm", "bench"]) {
    rmSync(path.join(tree, name), { recursive: true, force: true });
    cpSync(path.join(root, name), path.join(tree, name), { recursive: true, preserveTimestamps: true });
  }
  const configured = run("cmake", ["-S", ".", "-B", "build", "-DCMAKE_BUILD_TYPE=Release", "-DAPOLLONIUS_SHADOW_CHECK=ON"], 600);
  if (configured.status !== 0) throw new Error(configured.stderr);
  const built = build();
  if (built.status !== 0) throw new Error(built.stderr);
}

const build = () => run("cmake", ["--build", "build", "--parallel", jobs], 3600);

/** The test programs, the one of the mutant's own folder first. */
function programsFor(file) {
  const own = `${file.split("/")[1]}_tests`;
  const programs = readdirSync(path.join(tree, "build")).filter((name) => name.endsWith("_tests"));
  return programs.sort((a, b) => (b === own) - (a === own) || a.localeCompare(b));
}

/** What notices the mutant: the name of a test, "hangs" or "does not build"; null if nothing does. */
function noticedBy(mutant) {
  const place = path.join(tree, mutant.file);
  const original = readFileSync(place, "utf8");
  writeFileSync(place, mutated(mutant));
  try {
    if (build().status !== 0) return "does not build";
    for (const program of programsFor(mutant.file)) {
      const result = run(path.join(tree, "build", program), ["--gtest_fail_fast", "--gtest_brief=1"], kSlowestTest);
      if (result.error?.code === "ETIMEDOUT" || result.signal === "SIGKILL") return `${program} hangs`;
      if (result.status === 0) continue;
      return /\[ {2}FAILED {2}\] (\S+)/.exec(result.stdout)?.[1] ?? `${program} ends with ${result.status ?? result.signal}`;
    }
    return null;
  } finally {
    writeFileSync(place, original);
  }
}

const earlier = existsSync(reportFile) ? JSON.parse(readFileSync(reportFile, "utf8")) : {};
const chosen = all.slice(Number(options.from), options.to ? Number(options.to) : undefined)
  .filter(({ file, equivalent }) => !equivalent && file.includes(options.only));
let isPrepared = false;
const survivors = [];
for (const mutant of chosen) {
  const key = digest(JSON.stringify([mutant.file, mutant.line, mutant.becomes]) + mutated(mutant));
  if (earlier[key] === undefined || earlier[key] === null) {
    if (!isPrepared) prepare();
    isPrepared = true;
    earlier[key] = noticedBy(mutant);
    writeFileSync(reportFile, JSON.stringify(earlier, null, 1));
  }
  const what = `${mutant.file}: ${mutant.line}  ->  ${mutant.becomes}`;
  console.log(`${earlier[key] ?? "NOT NOTICED"}\n    ${what}`);
  if (earlier[key] === null) survivors.push(what);
}
const unusable = chosen.length - chosen.filter((m) => earlier[digest(JSON.stringify([m.file, m.line, m.becomes]) + mutated(m))] !== "does not build").length;
console.log(`${chosen.length - survivors.length - unusable} of ${chosen.length - unusable} mutants noticed, ${unusable} do not build, ` +
            `${all.filter(({ equivalent }) => equivalent).length} are equivalent`);
process.exitCode = survivors.length * 20 > chosen.length - unusable ? 1 : 0;
