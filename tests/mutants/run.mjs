// Mutants: small changes to src/ that the tests must notice.
//
//   npm run mutants                        all of tests/mutants/mutants.json; an hour on two cores
//   npm run mutants -- --from 20 --to 40   some of them
//   npm run mutants -- --only predicate    those of files whose path has that in it
//   npm run mutants -- --longest 1         with tests of a second at most: a first look, which
//                                          keeps only the mutants that are noticed
//   npm run mutants -- --propose 150       prints as many new ones, spread over the files of src/:
//                                          for a person to choose from
//
// A mutant is a file, a piece of it (as tokens, whatever the layout), and what that piece becomes.
// All are put into one copy of the sources, each behind a switch (switched.mjs), which is built
// once, with the shadow check. Each test is run once without any mutant, to see how long it takes
// and which mutants it comes by; then the tests that come by a mutant are run with it, quick ones
// first, until one fails, ends or hangs. A mutant with an `equivalent` (why no test can notice it)
// is not run. The report goes to build/mutants/report.json after each mutant; noticed mutants are
// kept until the mutant or the file changes. A run of all writes docs/figures.json.
import { spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { recordFigures } from "../../tools/figures.mjs";
import { proposals } from "./propose.mjs";
import { inParallel, Suite } from "./suite.mjs";
import { switched } from "./switched.mjs";
import { normalized } from "./tokens.mjs";

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
const work = path.join(root, "build", "mutants");
const tree = path.join(work, "tree");
const reportFile = path.join(work, "report.json");

const { values: options } = parseArgs({
  options: {
    from: { type: "string", default: "0" },
    to: { type: "string" },
    only: { type: "string", default: "" },
    jobs: { type: "string", default: String(availableParallelism()) },
    longest: { type: "string", default: "Infinity" },
    propose: { type: "string" },
  },
});
const began = performance.now();
const jobs = Number(options.jobs),
  longest = Number(options.longest);

if (options.propose) {
  console.log(JSON.stringify(proposals(root, Number(options.propose)), null, 1));
  process.exit();
}

const all = JSON.parse(readFileSync(path.join(root, "tests/mutants/mutants.json"), "utf8"));
const digest = (...texts) =>
  createHash("sha256").update(JSON.stringify(texts)).digest("hex").slice(0, 16);
const sourceOf = (file) => readFileSync(path.join(root, file), "utf8");
const keyOf = ({ file, line, becomes }) =>
  digest(file, normalized(line), normalized(becomes), normalized(sourceOf(file)));

/** Writes a file of the copy if its content differs: an unchanged file is not compiled again. */
function write(name, content) {
  const place = path.join(tree, name);
  if (existsSync(place) && readFileSync(place).equals(Buffer.from(content))) return;
  mkdirSync(path.dirname(place), { recursive: true });
  writeFileSync(place, content);
}

function run(program, args) {
  const { status } = spawnSync(program, args, {
    cwd: tree,
    stdio: ["ignore", "inherit", "inherit"],
  });
  if (status !== 0) throw new Error(`${program} ${args.join(" ")} ends with ${status}`);
}

/** Writes the copy of the sources, with all mutants in it. */
function writeTree() {
  const files = new Map(); // by name: [mutant, number]
  all.forEach((mutant, number) =>
    files.set(mutant.file, [...(files.get(mutant.file) ?? []), [mutant, number]]),
  );
  for (const folder of ["tests", "wasm", "bench", "cmake", "src"]) {
    for (const name of readdirSync(path.join(root, folder), { recursive: true })) {
      const file = path.join(folder, name);
      if (name.includes("node_modules")) continue; // tests/strangers has one
      if (!statSync(path.join(root, file)).isFile()) continue;
      const mutants = files.get(file);
      write(
        file,
        mutants ? switched(sourceOf(file), mutants) : readFileSync(path.join(root, file)),
      );
    }
  }
  for (const name of ["CMakeLists.txt", "package.json"]) write(name, sourceOf(name));
  for (const name of ["switch.h", "switch.cpp"])
    write(`src/${name}`, sourceOf(`tests/mutants/${name}`));
}

/**
 * Builds the tree, with the shadow check or without; all programs or some. Returns where they are.
 */
function built(folder, shadowCheck, targets = []) {
  run("cmake", [
    "-S",
    ".",
    "-B",
    folder,
    "-DCMAKE_BUILD_TYPE=Release",
    `-DAPOLLONIUS_SHADOW_CHECK=${shadowCheck ? "ON" : "OFF"}`,
    `-DCMAKE_CXX_FLAGS=-w -include ${path.join(tree, "src/switch.h")}`,
    "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
  ]);
  run("cmake", [
    "--build",
    folder,
    "--parallel",
    String(jobs),
    ...targets.flatMap((target) => ["--target", target]),
  ]);
  return path.join(tree, folder);
}

const folderOf = (file) =>
  path.dirname(file).replace(/^src\/?/, "") || (file.includes("voronoi") ? "geometry" : "diagram");

const report = existsSync(reportFile) ? JSON.parse(readFileSync(reportFile, "utf8")) : {};
const chosen = all
  .map((mutant, number) => ({ ...mutant, number }))
  .slice(Number(options.from), options.to ? Number(options.to) : undefined)
  .filter(({ file }) => file.includes(options.only));
const mutants = chosen.filter(({ equivalent }) => !equivalent);
const open = mutants.filter((mutant) => !report[keyOf(mutant)]);
if (open.length > 0) {
  writeTree();
  const suite = new Suite(path.join(work, "measured.json"), jobs);
  const skipped = await suite.measure(built("build", true), longest);
  if (longest === Infinity) {
    // as in the wasm step of npm test
    await suite.measure(built("build-plain", false, Object.keys(skipped)), longest, skipped);
  }
  await inParallel(open, jobs, async (mutant) => {
    const key = keyOf(mutant);
    const noticed = await suite.noticedBy(mutant.number, folderOf(mutant.file), longest);
    if (noticed !== null || longest === Infinity) report[key] = noticed;
    writeFileSync(reportFile, JSON.stringify(report, null, 1));
    console.log(
      `${mutant.number}: ${noticed ?? "NOT NOTICED"}\n` +
        `    ${mutant.file}: ${mutant.line}  ->  ${mutant.becomes}`,
    );
  });
}

const survivors = mutants.filter((mutant) => !report[keyOf(mutant)]);
for (const { number, file, line, becomes } of survivors)
  console.log(`NOT NOTICED ${number} ${file}: ${line}  ->  ${becomes}`);
const counted = {};
for (const mutant of chosen) {
  const folder = path.dirname(mutant.file);
  counted[folder] ??= { mutants: 0, noticed: 0, equivalent: 0, "not noticed": 0 };
  const row = counted[folder];
  ++row.mutants;
  ++row[mutant.equivalent ? "equivalent" : report[keyOf(mutant)] ? "noticed" : "not noticed"];
}
console.table(counted);
console.log(
  `${mutants.length - survivors.length} of ${mutants.length} mutants noticed, ` +
    `${chosen.length - mutants.length} are equivalent`,
);
if (chosen.length === all.length && longest === Infinity) {
  recordFigures("mutants", {
    all: all.length,
    run: mutants.length,
    noticed: mutants.length - survivors.length,
    percent: (100 * (mutants.length - survivors.length)) / mutants.length,
    equivalent: chosen.length - mutants.length,
    minutes: Math.round((performance.now() - began) / 60_000),
  });
}
process.exitCode = survivors.length * 20 > mutants.length ? 1 : 0;
