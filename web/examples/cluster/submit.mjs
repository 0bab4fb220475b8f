// Assigns points to their nearest circles, by as many workers as there are: splits the points into
// jobs, and shows how far the workers are. What is there already is not done again.
import { statSync } from "node:fs";
import path from "node:path";
import { count, readOptions, runOptions, twoColumns, whereItRuns } from "./command_line.mjs";
import { readWhole } from "./files.mjs";
import { formatOf, formats } from "./formats/index.mjs";
import { unpacked } from "./formats/unpack.mjs";
import { perform, runOf } from "./run.mjs";
import { hashOf } from "./snapshots.mjs";

const usage = `
node submit.mjs --folder work --snapshot stations.bin --points buildings.csv [--distances]

Assigns points to their nearest circles, by as many workers as there are. Start it again after
Ctrl-C, or after collect.mjs has found damaged parts: what is there already is not done again.

  --folder      a folder that submit, workers and collect share; paths below it are kept
                relative, so that it may be mounted elsewhere on other machines
  --snapshot    a file of what diagram.toBytes() gave
  --points      .f64 (little-endian pairs), .csv, .arrow (IPC file), .parquet (GeoParquet, too),
                .geojson or .geojsonl (a feature a line), or one of these with .gz; .gz and
                .geojson are first unpacked into the folder
  --distances   distances to the circles, too
  --columns     names of the two columns, by default x,y. GeoJSON, and GeoParquet without such
                columns, have points instead
  --per-job     points of a job, by default 1000000
${whereItRuns}`;

const options = readOptions(usage, {
  folder: { type: "string", required: true },
  snapshot: { type: "string", required: true },
  points: { type: "string", required: true },
  distances: { type: "boolean", default: false },
  columns: { type: "string", default: "x,y", as: twoColumns },
  "per-job": { type: "string", default: "1000000", as: count },
  ...runOptions,
});
const { folder, points, distances } = options;
const snapshot = await readWhole(options.snapshot);
const format = formatOf(points);
const settings = { perJob: options["per-job"], columns: options.columns };
const { size, mtimeMs } = statSync(points);

/** A path that is the same for all who have the folder, if the file is in it. */
function shared(file) {
  const inFolder = path.relative(folder, file);
  return inFolder.startsWith("..") ? path.resolve(file) : inFolder;
}
const common = { format, distances, snapshot: hashOf(snapshot) };
const run = runOf({ points: shared(points), ...common, ...settings, size, mtimeMs });
const input = await unpacked(points, path.join(folder, `points-${run}`));

await perform(
  folder,
  {
    kind: "assign",
    run,
    unit: formats[format].unit,
    common: { ...common, input: shared(input) },
    jobs: await formats[format].split(input, settings),
  },
  { ...options, snapshot },
);
console.log(`All parts are there. Now: node collect.mjs --folder ${folder} --out RESULT`);
