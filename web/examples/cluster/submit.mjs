// Assigns points to their nearest circles, by as many workers as there are: splits the points into
// jobs, and shows how far the workers are. What is there already is not done again.
import { readFileSync, statSync } from "node:fs";
import path from "node:path";
import { columns, count, readOptions, seconds } from "./command_line.mjs";
import { formatOf, formats } from "./formats/index.mjs";
import { perform, runOf } from "./run.mjs";
import { hashOf } from "./snapshots.mjs";

const usage = `
node submit.mjs --folder work --snapshot stations.bin --points buildings.csv [--distances]

Assigns points to their nearest circles, by as many workers as there are. Start it again after
Ctrl-C, or after collect.mjs has found damaged parts: what is there already is not done again.

  --folder      a folder that submit, workers and collect share; paths below it are kept
                relative, so that it may be mounted elsewhere on other machines
  --snapshot    a file of what diagram.toBytes() gave
  --points      .f64 (little-endian pairs), .csv, or .arrow (IPC file)
  --distances   distances to the circles, too
  --columns     names of the two columns, by default x,y
  --per-job     points of a job, by default 1000000
  --patience    seconds without Redis after which it gives up, by default 20

REDIS_URL names a Redis that all machines reach; without it, one is started on this machine.`;

const options = readOptions(usage, {
  folder: { type: "string", required: true },
  snapshot: { type: "string", required: true },
  points: { type: "string", required: true },
  distances: { type: "boolean", default: false },
  columns: { type: "string", default: "x,y", as: columns },
  "per-job": { type: "string", default: "1000000", as: count },
  patience: { type: "string", default: "20", as: seconds },
});
const { folder, points, distances } = options;
const inFolder = path.relative(folder, points);
const input = inFolder.startsWith("..") ? path.resolve(points) : inFolder;
const snapshot = readFileSync(options.snapshot);
const format = formatOf(points);
const common = { input, format, distances, snapshot: hashOf(snapshot) };
const settings = { perJob: options["per-job"], columns: options.columns };
const { size, mtimeMs } = statSync(points);

await perform(
  folder,
  {
    kind: "assign",
    run: runOf({ ...common, ...settings, size, mtimeMs }),
    unit: formats[format].unit,
    common,
    jobs: await formats[format].split(points, settings),
  },
  { patience: options.patience, snapshot },
);
console.log(`All parts are there. Now: node collect.mjs --folder ${folder} --out RESULT`);
