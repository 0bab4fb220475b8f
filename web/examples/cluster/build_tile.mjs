// A job of build.mjs: the parts of cells that lie in a tile.
import path from "node:path";
import { CircleStore } from "./circle_store.mjs";
import { tile } from "./tile.mjs";

let opened; // the store that was asked for last

function storeOf(home, run) {
  if (opened?.run !== run) opened = { run, store: new CircleStore(home) };
  return opened.store;
}

/** The sections of the job's part: pairs of id and area; and features, one a line. */
export async function buildTile({ run, store, window, halo, tolerance, geojson }, context) {
  const circles = storeOf(path.resolve(context.folder, store), run);
  const { diagram, ids } = await tile(circles, window, halo);
  try {
    const voronoi = diagram.voronoi(window);
    const areas = voronoi.cellAreas();
    const own = [];
    for (let k = 0; k < areas.length; ++k) if (areas[k] > 0) own.push(k);
    const pairs = new Float64Array(2 * own.length);
    own.forEach((k, at) => {
      pairs[2 * at] = ids[k];
      pairs[2 * at + 1] = areas[k];
    });
    const features = geojson
      ? own.map((k) => feature(voronoi, k, ids[k], areas[k], tolerance))
      : [];
    context.items += own.length;
    return { areas: new Uint8Array(pairs.buffer), geojsonl: Buffer.from(features.join("")) };
  } finally {
    diagram.dispose();
  }
}

/** The part of a cell in the tile; whoever wants whole cells joins the parts of an id. */
function feature(voronoi, k, id, area, tolerance) {
  const polygons = (voronoi.cellParts(k, { tolerance }) ?? []).map((ring) => [ring]);
  const geometry =
    polygons.length === 1
      ? { type: "Polygon", coordinates: polygons[0] }
      : { type: "MultiPolygon", coordinates: polygons };
  return `${JSON.stringify({ type: "Feature", id, properties: { area }, geometry })}\n`;
}
