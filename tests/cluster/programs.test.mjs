// The four programs answer --help, and wrong input, with one sentence or the usage, never a stack
// trace; an error ends them with exit code 1.
import { mkdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { afterEach, describe, expect, test } from "@jest/globals";
import { Diagram } from "apollonius-diagram";
import { duration } from "../../web/examples/cluster/run.mjs";
import { emptyFolder, writeArray } from "./support/files.mjs";
import { isStack, start, stopAll } from "./support/processes.mjs";

afterEach(stopAll);

const folder = emptyFolder("programs");
const inFolder = (name) => path.join(folder, name);
writeFileSync(inFolder("snapshot.bin"), new Diagram([0, 0, 1]).toBytes());
writeArray(inFolder("points.f64"), new Float64Array(20));
writeArray(inFolder("circles.f64"), new Float64Array(30));
writeArray(inFolder("odd.f64"), new Float64Array(1));
writeFileSync(inFolder("points.txt"), "");
writeFileSync(inFolder("points.csv"), "a,b\n1,2\n");
writeFileSync(inFolder("plain.csv.gz"), "a,b\n1,2\n");
writeFileSync(inFolder("text.parquet"), "a,b\n1,2\n");
writeFileSync(inFolder("far.csv"), "x,y,r\n1,2,far\n");
writeArray(inFolder("wild.f64"), Float64Array.of(0, 0, 1, 0, Number.NaN, 1));
mkdirSync(inFolder("damaged"));
for (const name of ["folder.f64", "folder.csv", "folder.arrow", "folder.parquet", "folder.csv.gz"])
  mkdirSync(inFolder(name));
writeFileSync(inFolder("text.arrow"), "a,b\n1,2\n");
writeFileSync(inFolder("damaged/plan.json"), "{");

const submit = (changes) => {
  const given = { folder: "work", snapshot: "snapshot.bin", points: "points.f64", ...changes };
  return optionsOf(given, ["folder", "snapshot", "points"]);
};
const build = (changes) =>
  optionsOf({ folder: "work", circles: "circles.f64", ...changes }, ["folder", "circles"]);
const optionsOf = (given, paths) =>
  Object.entries(given)
    .filter(([, value]) => value !== undefined)
    .map(([name, value]) => `--${name}=${paths.includes(name) ? inFolder(value) : value}`);

async function said(program, args) {
  const { ended, output } = start(program, args, { env: { REDIS_URL: "redis://127.0.0.1:1" } });
  const code = await ended;
  expect(isStack(output())).toBe(false);
  return { code, text: output() };
}

const complete = {
  "submit.mjs": submit(),
  "build.mjs": build(),
  "worker.mjs": [`--folder=${inFolder("work")}`],
  "collect.mjs": [`--folder=${inFolder("work")}`, `--out=${inFolder("result")}`],
};

describe.each(Object.entries(complete))("%s", (program, args) => {
  test("--help names each option, and what the program does", async () => {
    const { code, text } = await said(program, ["--help"]);
    expect(code).toBe(0);
    expect(text).toMatch(new RegExp(`^node ${program} --folder work`));
    for (const option of args) expect(text).toContain(`\n  ${option.split("=")[0]} `);
  });

  test("an unknown option, one without a value, and words beside options", async () => {
    for (const [more, problem] of [
      [["--fodler", "x"], "Unknown option '--fodler'"],
      [["--folder"], "argument missing"],
      [["x"], "Unexpected argument 'x'"],
    ]) {
      const { code, text } = await said(program, [...args, ...more]);
      expect(code).toBe(1);
      expect(text).toContain(problem);
      expect(text).toContain(`\`node ${program} --help\``);
    }
  });

  test("each option that is missing is named", async () => {
    for (const option of args) {
      const others = args.filter((each) => each !== option);
      const { code, text } = await said(program, others);
      expect(code).toBe(1);
      expect(text).toContain(`${option.split("=")[0]} is missing\n`);
    }
  });
});

const isFolder = /: illegal operation on a directory\n$/;
const none = /: no such file or directory\n$/;
test.each([
  ["submit.mjs", submit({ snapshot: "none.bin" }), /none\.bin/, none],
  ["submit.mjs", submit({ points: "none.f64" }), /none\.f64/, none],
  ["submit.mjs", submit({ points: "points.txt" }), /expected one of \.arrow/],
  ["submit.mjs", submit({ points: "odd.f64" }), /no whole number of pairs/],
  ["submit.mjs", submit({ points: "points.csv" }), /no columns x, y among a, b: see --columns/],
  ["submit.mjs", submit({ points: "plain.csv.gz" }), /plain\.csv\.gz: incorrect header check/],
  ["submit.mjs", submit({ points: "text.parquet" }), /text\.parquet: parquet file invalid/],
  ["submit.mjs", submit({ points: "text.arrow" }), /text\.arrow: no Arrow IPC file/],
  ["submit.mjs", submit({ snapshot: "damaged" }), /programs.damaged/, isFolder],
  ["submit.mjs", submit({ points: "folder.csv" }), /folder\.csv/, isFolder],
  ["submit.mjs", submit({ points: "folder.arrow" }), /folder\.arrow/, isFolder],
  ["submit.mjs", submit({ points: "folder.parquet" }), /folder\.parquet/, isFolder],
  ["submit.mjs", submit({ points: "folder.csv.gz" }), /folder\.csv\.gz/, isFolder],
  ["build.mjs", build({ circles: "folder.csv" }), /folder\.csv/, isFolder],
  ["submit.mjs", submit({ workers: "2" }), /--workers is for one machine: there is a REDIS_URL/],
  ["submit.mjs", submit({ columns: "x" }), /--columns is two names/],
  ["submit.mjs", submit({ "per-job": "0" }), /--per-job is a whole number from 1 on, not 0/],
  ["submit.mjs", submit({ patience: "-1" }), /--patience is a number of seconds, not -1/],
  ["submit.mjs", submit({ folder: "points.f64" }), /points\.f64.*: not a directory/],
  ["submit.mjs", submit({ folder: "damaged" }), /damaged.plan\.json is damaged/],
  ["build.mjs", build({ circles: "none.f64" }), /none\.f64/, none],
  ["build.mjs", build({ circles: "odd.f64" }), /no whole number of x, y, r triples/],
  ["build.mjs", build({ circles: "points.txt" }), /expected one of \.arrow/],
  ["build.mjs", build({ circles: "points.csv" }), /no columns x, y, r among a, b: see --columns/],
  ["build.mjs", build({ circles: "far.csv" }), /far\.csv.*no number: 1,2,far/],
  ["build.mjs", build({ circles: "wild.f64" }), /wild\.f64: circle 1 is 0, NaN, 1/],
  ["build.mjs", build({ columns: "x,y" }), /--columns is three names/],
  ["build.mjs", build({ window: "0,0,1" }), /--window is xmin,ymin,xmax,ymax, not 0,0,1/],
  ["build.mjs", build({ window: "0,0,0,1" }), /--window is/],
  ["build.mjs", build({ window: "0,,1,1" }), /--window is/],
  ["build.mjs", build({ "per-tile": "1.5" }), /--per-tile is a whole number/],
  ["build.mjs", build({ tolerance: "0" }), /--tolerance is a number above 0, not 0/],
  ["build.mjs", build({ tolerance: "fine" }), /--tolerance is a number above 0, not fine/],
  ["worker.mjs", ["--folder", folder, "--lock", "soon"], /--lock is a number of seconds, not soon/],
  ["worker.mjs", ["--folder", folder, "--concurrency", "0"], /--concurrency is a whole number/],
  ["collect.mjs", ["--folder", inFolder("none"), "--out", "x"], /none has no run/],
  ["collect.mjs", ["--folder", inFolder("damaged"), "--out", "x"], /plan\.json is damaged/],
])("%s %j", async (program, args, ...patterns) => {
  const { code, text } = await said(program, args);
  expect(code).toBe(1);
  for (const pattern of patterns) expect(text).toMatch(pattern);
});

test("a worker without REDIS_URL says who starts workers then", async () => {
  const { ended, output } = start("worker.mjs", ["--folder", folder]);
  expect(await ended).toBe(1);
  expect(output()).toMatch(/^REDIS_URL is missing: without it, submit\.mjs and build\.mjs/);
});

test("how long it will take is said in words", () => {
  const said = [0.2, 59, 60, 61.5, 3599, 3600, 86_399].map(duration);
  expect(said.join()).toBe("1 s,59 s,1 min 0 s,1 min 2 s,59 min 59 s,1 h 0 min,23 h 59 min");
});
