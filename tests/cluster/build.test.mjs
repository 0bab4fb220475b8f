// Cells tile by tile, by workers: areas and shapes are those of the one diagram of all circles.
import { readFileSync } from "node:fs";
import path from "node:path";
import { afterEach, expect, test } from "@jest/globals";
import { Diagram } from "apollonius-diagram";
import { stopRedis } from "../../web/examples/cluster/redis.mjs";
import { isThorough } from "../support/effort.mjs";
import { generator } from "../wasm/support/random.mjs";
import { emptyFolder, readDoubles, writeArray } from "./support/files.mjs";
import { finish, start, stopAll } from "./support/processes.mjs";

const withRedis = process.env.REDIS_SERVER === "" ? test.skip : test;
const count = isThorough ? 1_000_000 : 60_000;
const perTile = isThorough ? 20_000 : 2000;
const window = [100, 50, 900, 980];

const folder = emptyFolder("build");
const work = path.join(folder, "work");
afterEach(async () => {
  stopAll();
  await stopRedis(work);
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

withRedis(
  "areas add up to the window, and are those of one diagram; features are the cells' parts",
  async () => {
    const xyr = circles();
    const file = writeArray(path.join(folder, "circles.f64"), xyr);
    const workers = [0, 1].map(() => start("worker.mjs", ["--folder", work]));
    await finish("build.mjs", [
      ...["--folder", work, "--circles", file, "--window", window.join()],
      ...["--per-tile", String(perTile), "--geojson"],
    ]);
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

    const features = readFileSync(path.join(folder, "result.geojsonl"), "utf8").trim().split("\n");
    const sums = new Float64Array(count);
    let drawn = 0;
    for (const { id, properties, geometry } of features.map((line) => JSON.parse(line))) {
      sums[id] += properties.area;
      const { type, coordinates } = geometry;
      for (const rings of type === "Polygon" ? [coordinates] : coordinates)
        drawn += areaOf(rings[0]);
    }
    expect([...sums]).toEqual([...areas]); // the same numbers in the same order
    expect(Math.abs(drawn - all)).toBeLessThan(1e-6 * all); // polygons leave no gaps but for rounding
    const memory = workers.map(({ output }) => Number(/"peakMegabytes":(\d+)/.exec(output())[1]));
    expect(Math.max(...memory)).toBeLessThan(1024);
  },
  isThorough ? 600_000 : 60_000,
);
