// A job of build.mjs: the parts of cells that lie in a tile.
import path from "node:path";
import { setImmediate } from "node:timers/promises";
import { kTogether } from "./cells/box_tree.mjs";
import { cellFormats } from "./cells/index.mjs";
import { CircleStore } from "./circle_store.mjs";
import { tile } from "./tile.mjs";
import { areaSections } from "./tiles.mjs";

const kAtOnce = 1000; // cells between which the worker may tell Redis that it is alive

let opened; // the store that was asked for last

/** The store of a run, opened once; again if that failed. */
async function storeOf(home, { run, count }) {
  if (opened?.run === run) return opened.store;
  const store = await CircleStore.open(home);
  if (store.count !== count)
    throw new Error(`${home} has ${store.count} circles, the plan ${count}`);
  opened = { run, store };
  return store;
}

/** The sections of the job's part: pairs of id and area; and cells, a section a format. */
export async function buildTile({ run, count, store, window, halo, tolerance, cells }, context) {
  const circles = await storeOf(path.resolve(context.folder, store), { run, count });
  const { diagram, ids } = await tile(circles, window, halo);
  try {
    const voronoi = diagram.voronoi(window);
    const areas = voronoi.cellAreas();
    const own = [];
    for (let k = 0; k < areas.length; ++k) if (areas[k] > 0) own.push(k);
    if (cells.length > 0) sortInStrips(own, diagram);
    const pairs = new Float64Array(2 * own.length);
    const encoded = Object.fromEntries(cells.map((format) => [format, []]));
    for (const [at, k] of own.entries()) {
      pairs[2 * at] = ids[k];
      pairs[2 * at + 1] = areas[k];
      if (cells.length === 0) continue;
      if (at % kAtOnce === 0) await setImmediate();
      // The part of the cell in the tile; whoever wants whole cells joins the parts of an id.
      // Without a tolerance of the plan it is the package's own for cells of that size.
      const polygons = voronoi.cellParts(k, { tolerance, flat: true }) ?? [];
      const cell = { id: ids[k], area: areas[k], polygons };
      for (const format of cells) encoded[format].push(cellFormats[format].encode(cell));
    }
    context.items += own.length;
    const sections = areaSections(pairs, count);
    for (const format of cells) sections[format] = Buffer.concat(encoded[format]);
    return sections;
  } finally {
    diagram.dispose();
  }
}

/** Sorts sites so that 16 neighbours in the list, a node of BoxTree, are near each other. */
function sortInStrips(sites, diagram) {
  const places = new Map(sites.map((k) => [k, diagram.site(k)]));
  sites.sort((a, b) => places.get(a).y - places.get(b).y);
  // strips are as high as nodes are wide
  const inStrip = Math.ceil(Math.sqrt(kTogether * sites.length));
  const strips = [];
  for (let k = 0; k < sites.length; k += inStrip) {
    const strip = sites.slice(k, k + inStrip);
    strips.push(...strip.sort((a, b) => places.get(a).x - places.get(b).x));
  }
  strips.forEach((k, at) => (sites[at] = k));
}
