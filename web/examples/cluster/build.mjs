// The cells of more circles than one memory holds, tile by tile, by as many workers as there are:
//
//   node build.mjs --folder work --circles circles.f64 [--window xmin,ymin,xmax,ymax] [--geojson]
//
// Sorts the circles into a store in the folder, splits the window into tiles, and shows how far the
// workers are; start it again after Ctrl-C. Then collect.mjs gives the area of each cell, and the
// parts of cells as GeoJSON, one feature a line. docs/SCALE.md says why each tile is exact.
//
//   --circles     little-endian float64 triples x, y, r; ids are 0, 1, 2, …
//   --window      by default the smallest that has all centres
//   --per-tile    circles of a tile at most, by default 100000: some 200 MB of a worker's memory,
//                 600 with --geojson
//   --geojson     the cells themselves, too
import { existsSync, statSync } from "node:fs";
import path from "node:path";
import { parseArgs } from "node:util";
import { CircleStore } from "./circle_store.mjs";
import { makeStore } from "./make_store.mjs";
import { perform, runOf } from "./run.mjs";
import { planTiles } from "./tiles.mjs";

const { values: options } = parseArgs({
  options: {
    folder: { type: "string" },
    circles: { type: "string" },
    window: { type: "string" },
    "per-tile": { type: "string", default: "100000" },
    geojson: { type: "boolean", default: false },
  },
});
for (const name of ["folder", "circles"])
  if (!options[name]) throw new Error(`--${name} is missing`);

const { folder, circles, geojson } = options;
const perTile = Number(options["per-tile"]);
const asked = options.window?.split(",").map(Number);
const { size, mtimeMs } = statSync(circles);
const run = runOf({ circles: path.resolve(circles), size, mtimeMs, asked, perTile, geojson });

const home = path.join(folder, `store-${run}`);
const isThere = existsSync(path.join(home, "index.json"));
if (!isThere) console.log("Sorting the circles");
const store = isThere
  ? new CircleStore(home)
  : await makeStore(home, circles, { window: asked, perTile });
const window = asked ?? store.bounds;
const jobs = planTiles(store, window, perTile);
// of polygons: as by default for a tile of average size
const [xmin, ymin, xmax, ymax] = window;
const tolerance = (2 ** -13 * Math.hypot(xmax - xmin, ymax - ymin)) / Math.sqrt(jobs.length);
const common = { store: path.basename(home), count: store.count, window, tolerance, geojson };

await perform(folder, { kind: "tile", run, unit: "circles", common, jobs });
console.log(`All tiles are there. Now: node collect.mjs --folder ${folder} --out RESULT`);
