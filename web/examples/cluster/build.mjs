// The cells of more circles than one memory holds, tile by tile, by as many workers as there are:
// sorts the circles into a store in the folder, splits the window into tiles, and shows how far the
// workers are. docs/SCALE.md says why each tile is exact.
import { existsSync, statSync } from "node:fs";
import { rm } from "node:fs/promises";
import path from "node:path";
import { cellFormats } from "./cells/index.mjs";
import { CircleStore } from "./circle_store.mjs";
import {
  count,
  positive,
  readOptions,
  rectangle,
  runOptions,
  threeColumns,
  whereItRuns,
} from "./command_line.mjs";
import { formatOf } from "./formats/index.mjs";
import { unpacked } from "./formats/unpack.mjs";
import { makeStore } from "./make_store.mjs";
import { perform, runOf } from "./run.mjs";
import { planTiles } from "./tiles.mjs";

const usage = `
node build.mjs --folder work --circles circles.f64 [--window xmin,ymin,xmax,ymax] [--flatgeobuf]

Computes the cells of circles tile by tile, by as many workers as there are. Start it again after
Ctrl-C: what is there already is not done again. Then collect.mjs gives the area of each cell, and
the parts of cells in the formats that are asked for. Areas are exact; polygons follow the cells'
curves within the tolerance, so theirs are not quite these areas.

  --folder      a folder that build, workers and collect share
  --circles     .f64 (little-endian triples x, y, r), .csv, .arrow (IPC file), .parquet (GeoParquet,
                too), .geojson or .geojsonl (a feature a line), or one of these with .gz; .gz and
                .geojson are first unpacked into the folder. Ids are 0, 1, 2, …
  --columns     names of the three columns, by default x,y,r. GeoJSON, and GeoParquet without the
                first two, have points instead, and the third is a property or column
  --window      by default the smallest that has all centres
  --per-tile    circles of a tile at most, by default 100000: some 200 MB of a worker's memory,
                600 with cells
  --geojson     the cells themselves, too, as GeoJSON, a feature a line
  --flatgeobuf  the cells as FlatGeobuf, with an index
  --geoparquet  the cells as GeoParquet
  --tolerance   how far polygons may be from the curves, in the unit of the circles; by default what
                the package takes for a cell in a window as large as its tile
${whereItRuns}`;

const options = readOptions(usage, {
  folder: { type: "string", required: true },
  circles: { type: "string", required: true },
  window: { type: "string", as: rectangle },
  "per-tile": { type: "string", default: "100000", as: count },
  columns: { type: "string", default: "x,y,r", as: threeColumns },
  geojson: { type: "boolean", default: false },
  flatgeobuf: { type: "boolean", default: false },
  geoparquet: { type: "boolean", default: false },
  tolerance: { type: "string", as: positive },
  ...runOptions,
});
const { folder, circles, columns, tolerance } = options;
const { window: asked, "per-tile": perTile } = options;
const cells = Object.keys(cellFormats).filter((format) => options[format]);
formatOf(circles); // refuses what has none, before anything is written
const { size, mtimeMs } = statSync(circles);
const facts = {
  circles: path.resolve(circles),
  size,
  mtimeMs,
  columns,
  asked,
  perTile,
  cells,
  tolerance,
};
const run = runOf(facts);

const home = path.join(folder, `store-${run}`);
async function sorted() {
  console.log("Sorting the circles");
  const input = await unpacked(circles, path.join(folder, `circles-${run}`));
  const store = await makeStore(home, input, { window: asked, perTile, columns });
  if (input !== circles) await rm(input); // the store has all of it
  return store;
}
const store = existsSync(home) ? await CircleStore.open(home) : await sorted();
const window = asked ?? store.bounds;
const jobs = planTiles(store, window, perTile).map(({ window, halo }) => ({ window, halo }));
// Names of columns say what the numbers are; most formats have no other place for it.
const isLonLat = /^lon/i.test(columns[0]) && /^lat/i.test(columns[1]);
const common = {
  store: path.basename(home),
  count: store.count,
  window,
  tolerance,
  cells,
  isLonLat,
};

await perform(folder, { kind: "tile", run, unit: "tiles", common, jobs }, options);
console.log(`All tiles are there. Now: node collect.mjs --folder ${folder} --out RESULT`);
