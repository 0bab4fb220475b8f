// Assigns points to their nearest circles, by as many workers as there are:
//
//   node submit.mjs --folder work --snapshot stations.bin --points buildings.csv [--distances]
//
// Splits the points into jobs, and shows how far the workers are. What is there already is not done
// again: start it again after Ctrl-C, or after `collect.mjs` has found damaged parts.
//
//   --folder      a folder that submit, workers and collect share; paths below it are kept
//                 relative, so that it may be mounted elsewhere on other machines
//   --snapshot    a file of what diagram.toBytes() gave
//   --points      .f64 (little-endian pairs), .csv, or .arrow (IPC file)
//   --distances   distances to the circles, too
//   --columns     names of the two columns, by default x,y
//   --per-job     points of a job, by default 1000000
import { readFileSync, statSync } from "node:fs";
import path from "node:path";
import { parseArgs } from "node:util";
import { formatOf, formats } from "./formats/index.mjs";
import { perform, runOf } from "./run.mjs";
import { hashOf } from "./snapshots.mjs";

const { values: options } = parseArgs({
  options: {
    folder: { type: "string" },
    snapshot: { type: "string" },
    points: { type: "string" },
    distances: { type: "boolean", default: false },
    columns: { type: "string", default: "x,y" },
    "per-job": { type: "string", default: "1000000" },
  },
});
for (const name of ["folder", "snapshot", "points"])
  if (!options[name]) throw new Error(`--${name} is missing`);

const { folder, points, distances } = options;
const inFolder = path.relative(folder, points);
const input = inFolder.startsWith("..") ? path.resolve(points) : inFolder;
const snapshot = readFileSync(options.snapshot);
const format = formatOf(points);
const common = { input, format, distances, snapshot: hashOf(snapshot) };
const settings = { perJob: Number(options["per-job"]), columns: options.columns.split(",") };
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
  { snapshot },
);
console.log(`All parts are there. Now: node collect.mjs --folder ${folder} --out RESULT`);
