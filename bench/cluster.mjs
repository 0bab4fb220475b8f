// npm run bench -- cluster: points and tiles by the workers of web/examples/cluster, with one
// worker and with two, as a user starts them; each in turn, several times.
//
//   npm run bench -- cluster           about ten minutes; writes bench/results/cluster.md
//   npm run bench -- cluster --rounds 1
//   npm run bench -- cluster --quick   under a minute; writes build/bench-results/cluster.md
import { spawn } from "node:child_process";
import { mkdirSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import path from "node:path";
import { setTimeout } from "node:timers/promises";
import { parseArgs } from "node:util";
import { buildPackage } from "../tools/build.mjs";
import { run as execute, SetUpError } from "../tools/toolchain/process.mjs";
import { ensureRedis } from "../tools/toolchain/redis.mjs";
import { machine } from "./machine.mjs";
import { median } from "./measure.mjs";
import { drafts, results, root } from "./places.mjs";
import { short, table } from "./tables.mjs";

const example = path.join(root, "web/examples/cluster");
const home = path.join(root, "build/bench-cluster");

const modes = {
  quick: { rounds: 1, sites: 1e5, points: 4e6, perJob: 2e5, circles: 5e5, perTile: 25_000 },
  default: { rounds: 3, sites: 1e6, points: 4e7, perJob: 1e6, circles: 1e7, perTile: 1e5 },
};

/** A seeded generator of numbers in [0, 1). */
function generator(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** Centres in the unit square, radii of which some 5 % of the circles are hidden (README.md). */
function circles(count) {
  const random = generator(1);
  const largest = 0.4502 / Math.sqrt(count);
  return Float64Array.from({ length: 3 * count }, (_, k) => random() * (k % 3 === 2 ? largest : 1));
}

function write(name, array) {
  const file = path.join(home, name);
  writeFileSync(file, new Uint8Array(array.buffer, array.byteOffset, array.byteLength));
  return file;
}

/** Starts a worker, which reports its work when it is ended. */
function startWorker(folder, env) {
  const child = spawn(process.execPath, [path.join(example, "worker.mjs"), "--folder", folder], {
    env: { ...process.env, ...env },
    stdio: ["ignore", "pipe", "ignore"],
  });
  let text = "";
  child.stdout.on("data", (more) => (text += more));
  return async () => {
    child.kill("SIGTERM");
    await new Promise((resolve) => child.once("close", resolve));
    return JSON.parse(text.trim().split("\n").at(-1));
  };
}

/**
 * Makes one run. Returns items a second, from the end of each worker's first part to the end of its
 * last one (by then the code is compiled and the snapshot restored), and the workers' reports.
 */
async function measure(program, args, workers, items) {
  const folder = path.join(home, "work");
  rmSync(folder, { recursive: true, force: true });
  const { startHere } = await import("../web/examples/cluster/this_machine.mjs");
  const redis = startHere(folder, 0); // and no workers but these, as those tell nothing
  const env = { REDIS_URL: redis.url };
  const ends = Array.from({ length: workers }, () => startWorker(folder, env));
  execute(process.execPath, [path.join(example, program), "--folder", folder, ...args], { env });
  const reports = await Promise.all(ends.map((end) => end()));
  await redis.close();
  const parts = path.join(
    folder,
    readdirSync(folder).find((name) => name.startsWith("parts-")),
  );
  const times = readdirSync(parts).map((name) => statSync(path.join(parts, name)).mtimeMs);
  times.sort((a, b) => a - b);
  const share = (times.length - workers) / times.length;
  return { rate: (1000 * items * share) / (times.at(-1) - times[workers - 1]), reports };
}

/** `nearestMany` alone in this process, in pieces as large as jobs: points a second. */
async function alone(diagram, points, perJob) {
  diagram.nearestMany(points.subarray(0, 2 * perJob)); // warm-up
  const start = performance.now();
  for (let k = 0; k < points.length; k += 2 * perJob)
    diagram.nearestMany(points.subarray(k, k + 2 * perJob));
  return (500 * points.length) / (performance.now() - start);
}

async function measurePoints({ rounds, sites, points: count, perJob }) {
  const { Diagram } = await import("apollonius-diagram"); // not before it has been built
  const diagram = new Diagram(circles(sites));
  const snapshot = write("snapshot.bin", diagram.toBytes());
  const random = generator(2);
  const points = Float64Array.from({ length: 2 * count }, random);
  const file = write("points.f64", points);
  const args = ["--snapshot", snapshot, "--points", file, "--distances", "--per-job", perJob];
  const found = { alone: [], 1: [], 2: [], other: [] };
  for (let round = 0; round < rounds; ++round) {
    found.alone.push(await alone(diagram, points, perJob));
    for (const workers of [1, 2]) {
      const { rate, reports } = await measure("submit.mjs", args.map(String), workers, count);
      found[workers].push(rate);
      if (workers === 1) found.other.push(1 - reports[0].inFindMany / reports[0].busy);
      await setTimeout(1000);
    }
  }
  diagram.dispose();
  return found;
}

async function measureTiles({ rounds, circles: count, perTile }) {
  const file = write("circles.f64", circles(count));
  const found = { 1: [], 2: [], memory: 0 };
  for (let round = 0; round < rounds; ++round) {
    for (const workers of [1, 2]) {
      const args = ["--circles", file, "--per-tile", String(perTile)];
      const { rate, reports } = await measure("build.mjs", args, workers, count);
      found[workers].push(rate);
      found.memory = Math.max(found.memory, ...reports.map(({ peakMegabytes }) => peakMegabytes));
    }
  }
  return found;
}

const range = (values) => `${short(Math.min(...values))}..${short(Math.max(...values))}`;
const millions = (values) => {
  const rates = values.map((value) => value / 1e6);
  return [short(median(rates)), range(rates)];
};

function report(mode, points, tiles, facts) {
  const ratio = (found) => found[2].map((rate, k) => rate / found[1][k]);
  const percent = (values) => values.map((value) => 100 * value);
  const { cpu, cores, memory, system, node, commit, date, load } = facts;
  const rows = [
    ["points: `findMany` alone, millions a second", ...millions(points.alone), ""],
    ["points: 1 worker, millions a second", ...millions(points[1]), ""],
    ["points: 2 workers, millions a second", ...millions(points[2]), ""],
    ["points: 2 workers / 1", short(median(ratio(points))), range(ratio(points)), "≥ 1.8"],
    [
      "points: share of 1 worker's time that is not `findMany`, %",
      short(median(percent(points.other))),
      range(percent(points.other)),
      "≤ 15",
    ],
    ["tiles: 1 worker, millions of circles a second", ...millions(tiles[1]), ""],
    ["tiles: 2 workers, millions of circles a second", ...millions(tiles[2]), ""],
    ["tiles: 2 workers / 1", short(median(ratio(tiles))), range(ratio(tiles)), "≥ 1.8"],
    ["tiles: largest memory of a worker, MB", tiles.memory, "", "≤ 1000"],
  ];
  return `# Points and tiles by workers

${cpu}, ${cores} cores, ${memory}; ${system}; Node ${node}; commit ${commit}; ${date};
load before: ${load}

${mode.sites} circles and ${mode.points} points in jobs of ${mode.perJob}, with distances;
${mode.circles} circles in tiles of ${mode.perTile} at most, areas only. Medians and ranges of
${mode.rounds} round(s).

${table(["what", "median", "range", "goal"], rows)}
`;
}

/** Measures and writes the report. */
export async function measureCluster(args) {
  const { values } = parseArgs({
    args,
    options: { quick: { type: "boolean" }, rounds: { type: "string" } },
  });
  if (ensureRedis() === null) throw new SetUpError("no redis-server: install it");
  await buildPackage();
  const facts = machine();
  const mode = { ...modes[values.quick ? "quick" : "default"] };
  if (values.rounds) mode.rounds = Number(values.rounds);
  mkdirSync(home, { recursive: true });
  const points = await measurePoints(mode);
  const tiles = await measureTiles(mode);
  const text = report(mode, points, tiles, facts);
  console.log(text);
  const folder = values.quick ? drafts : results;
  mkdirSync(folder, { recursive: true });
  writeFileSync(path.join(folder, "cluster.md"), text);
  rmSync(home, { recursive: true });
  console.log(`Written to ${path.relative(process.cwd(), folder)}/cluster.md`);
}
