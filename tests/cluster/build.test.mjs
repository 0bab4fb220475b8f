// Cells tile by tile, by workers: areas and shapes are those of the one diagram of all circles.
import { writeFileSync } from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { afterEach, expect, test } from "@jest/globals";
import { Diagram } from "apollonius-diagram";
import { asyncBufferFromFile, parquetMetadataAsync, parquetReadObjects } from "hyparquet";
import GeoJSONReader from "jsts/org/locationtech/jts/io/GeoJSONReader.js";
import IsValidOp from "jsts/org/locationtech/jts/operation/valid/IsValidOp.js";
import { CircleStore } from "../../web/examples/cluster/circle_store.mjs";
import { tile } from "../../web/examples/cluster/tile.mjs";
import { isThorough } from "../support/effort.mjs";
import { generator } from "../wasm/support/random.mjs";
import { meets, polygonsOf, readFlatGeobuf, readLines } from "./support/cells.mjs";
import { emptyFolder, readDoubles, writeArray } from "./support/files.mjs";
import { finish, start, stopAll } from "./support/processes.mjs";
import { planOf, startRedis, stopServers } from "./support/redis.mjs";

const withRedis = process.env.REDIS_SERVER === "" ? test.skip : test;
const count = isThorough ? 1_000_000 : 60_000;
const perTile = isThorough ? 20_000 : 2000;
const window = [100, 50, 900, 980];

const folder = emptyFolder("build");
const work = path.join(folder, "work");
afterEach(async () => {
  stopAll();
  await stopServers();
});

/** Radii over some orders of magnitude, a third of the centres in one cluster; some covered. */
function circles() {
  const random = generator(3);
  const spot = (centre) => centre + 60 * (random() + random() - 1);
  const size = 25 / Math.sqrt(count);
  return Float64Array.from(
    Array.from({ length: count }, (_, k) => [
      k % 3 === 0 ? spot(200) : 1000 * random(),
      k % 3 === 0 ? spot(700) : 1000 * random(),
      Math.min(60, size * (1 - random()) ** -0.6),
    ]).flat(),
  );
}

/** Area of a closed ring. */
function areaOf(ring) {
  return ring.slice(1).reduce((sum, [x, y], k) => sum + (ring[k][0] * y - x * ring[k][1]) / 2, 0);
}

/** The rows of a GeoParquet file, its row groups, and its metadata. */
async function readGeoParquet(filename) {
  const file = await asyncBufferFromFile(filename);
  const { key_value_metadata, row_groups } = await parquetMetadataAsync(file);
  const { value } = key_value_metadata.find(({ key }) => key === "geo");
  return { rows: await parquetReadObjects({ file }), row_groups, geo: JSON.parse(value) };
}

withRedis(
  "areas are those of one diagram; features are the cells' parts, valid, alike in all formats",
  async () => {
    const xyr = circles();
    const file = writeArray(path.join(folder, "circles.f64"), xyr);
    const { url } = await startRedis({ folder: path.join(folder, "redis") });
    const shared = { env: { REDIS_URL: url } };
    const workers = [0, 1].map(() => start("worker.mjs", ["--folder", work], shared));
    const args = [
      ...["--folder", work, "--circles", file, "--window", window.join()],
      ...["--per-tile", String(perTile), "--geojson", "--flatgeobuf", "--geoparquet"],
    ];
    await finish("build.mjs", args, shared);
    await finish("collect.mjs", ["--folder", work, "--out", path.join(folder, "result")]);
    for (const { child } of workers) child.kill("SIGTERM");
    await Promise.all(workers.map(({ ended }) => ended));

    const whole = new Diagram(xyr).voronoi(window).cellAreas();
    const areas = readDoubles(path.join(folder, "result.areas.f64"));
    expect(areas).toHaveLength(count);
    const all = (window[2] - window[0]) * (window[3] - window[1]);
    expect(Math.abs(areas.reduce((sum, area) => sum + area) - all)).toBeLessThan(1e-9 * all);
    const worst = areas.reduce((most, area, id) => Math.max(most, Math.abs(area - whole[id])), 0);
    expect(worst).toBeLessThan(1e-9);

    const features = readLines(path.join(folder, "result.geojsonl"));
    const reader = new GeoJSONReader();
    const sums = new Float64Array(count);
    let drawn = 0;
    for (const [k, { id, properties, geometry }] of features.entries()) {
      sums[id] += properties.area;
      for (const rings of polygonsOf(geometry)) drawn += areaOf(rings[0]);
      if (isThorough || k % 8 === 0)
        expect(new IsValidOp(reader.read(geometry)).isValid()).toBe(true);
    }
    expect([...sums]).toEqual([...areas]); // equal bits: the numbers are added in equal order
    // polygons leave no gaps, up to rounding
    expect(Math.abs(drawn - all)).toBeLessThan(1e-6 * all);

    const asFlat = await readFlatGeobuf(path.join(folder, "result.fgb"));
    expect(asFlat.header.featuresCount).toBe(features.length);
    expect(asFlat.header.crs).toBe(null);
    expect([...asFlat.header.envelope]).toEqual(window);
    const isSame = (one, k) => {
      const { id, properties, geometry } = features[k];
      return (
        Number(one.id) === id &&
        one.area === properties.area &&
        JSON.stringify(polygonsOf(one.geometry)) === JSON.stringify(polygonsOf(geometry))
      );
    };
    const { features: flat } = asFlat;
    expect(flat).toHaveLength(features.length);
    expect(flat.every((one, k) => isSame({ ...one.properties, geometry: one.geometry }, k))).toBe(
      true,
    );
    for (const [minX, minY, maxX, maxY] of [window, [400, 400, 520, 510], [190, 690, 191, 691]]) {
      const rect = { minX, minY, maxX, maxY };
      const found = await readFlatGeobuf(path.join(folder, "result.fgb"), rect);
      const ids = features.filter(({ geometry }) => meets(geometry, rect)).map(({ id }) => id);
      expect(found.features.map(({ properties }) => properties.id)).toEqual(ids);
    }

    const { rows, row_groups, geo } = await readGeoParquet(path.join(folder, "result.parquet"));
    expect(rows).toHaveLength(features.length);
    expect(rows.every(isSame)).toBe(true);
    expect(row_groups.length).toBeGreaterThan(count / perTile / 2);
    expect(geo).toEqual({
      version: "1.1.0",
      primary_column: "geometry",
      columns: {
        geometry: {
          encoding: "WKB",
          geometry_types: ["Polygon", "MultiPolygon"],
          crs: null,
          bbox: window,
        },
      },
    });

    const memory = workers.map(({ output }) => Number(/"peakMegabytes":(\d+)/.exec(output())[1]));
    expect(Math.max(...memory)).toBeLessThan(1024);
  },
);

withRedis(
  "circles from gzipped CSV, whose columns say that they are longitude and latitude",
  async () => {
    const work = path.join(folder, "work-lon-lat");
    const random = generator(4);
    const xyr = Float64Array.from({ length: 3000 }, (_, k) => (k % 3 === 2 ? 0.01 : 1) * random());
    const text = Array.from({ length: 1000 }, (_, k) => xyr.subarray(3 * k, 3 * k + 3).join());
    const circles = path.join(folder, "circles.csv.gz");
    writeFileSync(circles, gzipSync(`lon,lat,size\n${text.join("\n")}`));
    const args = ["--folder", work, "--circles", circles, "--columns", "lon,lat,size"];
    await finish("build.mjs", [...args, "--per-tile", "300", "--flatgeobuf", "--geoparquet"]);
    const out = path.join(folder, "lon-lat");
    await finish("collect.mjs", ["--folder", work, "--out", out]);

    const areas = readDoubles(`${out}.areas.f64`);
    const { header, features } = await readFlatGeobuf(`${out}.fgb`);
    expect(header.crs.code).toBe(4326);
    const sums = new Float64Array(1000);
    for (const { properties } of features) sums[properties.id] += properties.area;
    expect([...sums]).toEqual([...areas]);
    const [xmin, ymin, xmax, ymax] = header.envelope;
    const whole = new Diagram(xyr).voronoi(header.envelope).cellAreas();
    const worst = Math.max(...areas.map((area, id) => Math.abs(area - whole[id])));
    expect(worst).toBeLessThan(1e-12 * (xmax - xmin) * (ymax - ymin));
    const { rows, geo } = await readGeoParquet(`${out}.parquet`);
    expect(geo.columns.geometry).not.toHaveProperty("crs"); // which is longitude and latitude
    expect(rows.map(({ id }) => Number(id))).toEqual(
      features.map(({ properties }) => properties.id),
    );
  },
);

/** The polygons of all tiles of a plan as the package gives them, in any order. */
async function polygonsOfTiles(home, tolerance) {
  const { common, jobs } = await planOf(home);
  const store = await CircleStore.open(path.join(home, common.store));
  const found = [];
  for (const { window: own, halo } of jobs) {
    const { diagram, ids } = await tile(store, own, halo);
    const voronoi = diagram.voronoi(own);
    for (const [k, area] of voronoi.cellAreas().entries()) {
      if (area === 0) continue;
      const parts = voronoi.cellParts(k, { tolerance, flat: true }) ?? [];
      const rings = parts.flat();
      found.push(`${ids[k]}: ${rings.map((ring) => ring.join()).join(";")}`);
    }
    diagram.dispose();
  }
  return found.sort();
}

withRedis("polygons keep to --tolerance; without it they are the package's own", async () => {
  const random = generator(8);
  const some = Float64Array.from({ length: 6000 }, (_, k) => (k % 3 === 2 ? 20 : 1000) * random());
  const file = writeArray(path.join(folder, "some.f64"), some);
  const home = path.join(folder, "tolerance");
  const points = [];
  for (const tolerance of [undefined, 1, 0.001]) {
    const args = ["--folder", `${home}-${tolerance}`, "--circles", file, "--per-tile", "300"];
    if (tolerance) args.push("--tolerance", String(tolerance));
    await finish("build.mjs", [...args, "--geojson", "--workers", "1"]);
    const out = `${home}-${tolerance}-cells`;
    await finish("collect.mjs", ["--folder", `${home}-${tolerance}`, "--out", out]);
    const features = readLines(`${out}.geojsonl`);
    const textOf = ({ id, geometry }) => {
      const rings = polygonsOf(geometry).flat();
      return `${id}: ${rings.map((ring) => ring.flat().join()).join(";")}`;
    };
    const expected = await polygonsOfTiles(`${home}-${tolerance}`, tolerance);
    expect(features.map(textOf).sort()).toEqual(expected);
    points.push(
      features.reduce((sum, { geometry }) => sum + polygonsOf(geometry).flat(2).length, 0),
    );
    if (tolerance !== 0.001) continue;
    for (const { properties, geometry } of features) {
      const drawn = polygonsOf(geometry)
        .flat()
        .reduce((sum, ring) => sum + areaOf(ring), 0);
      expect(Math.abs(drawn - properties.area)).toBeLessThan(0.001 * 4000); // by its boundary
    }
  }
  expect(points[2]).toBeGreaterThan(2 * points[1]);
  const other = start("build.mjs", [
    ...["--folder", `${home}-1`, "--circles", file, "--per-tile", "300", "--geojson"],
    ...["--tolerance", "2"],
  ]);
  expect(await other.ended).toBe(1);
  expect(other.output()).toContain("belongs to another run");
});
