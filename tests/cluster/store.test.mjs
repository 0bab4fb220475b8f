// The store and the tiles made of it: every circle once, every place of the window once.
import { cpSync, readdirSync, rmSync, statSync, truncateSync } from "node:fs";
import path from "node:path";
import { describe, expect, test } from "@jest/globals";
import { CircleStore } from "../../web/examples/cluster/circle_store.mjs";
import { makeStore } from "../../web/examples/cluster/make_store.mjs";
import { planTiles } from "../../web/examples/cluster/tiles.mjs";
import { generator } from "../wasm/support/random.mjs";
import { emptyFolder, writeArray } from "./support/files.mjs";

const count = 20_000;
const perTile = 500;

const families = {
  random: (random) => [random(), 3 * random(), random()],
  // centres on the very lines of buckets, and thirds that no double is
  lattice: (random) => [Math.floor(49 * random()) / 48, Math.floor(7 * random()) / 3, 0.1],
  clustered: (random) => [random() ** 9, 1e6 + random() ** 9, random() ** 20],
  line: (random) => [random(), 5, random()],
  copies: (random) => [random() < 0.5 ? 1 : random(), 1, 1],
};

async function stored(family) {
  const random = generator(11);
  const xyr = Float64Array.from(
    Array.from({ length: count }, () => families[family](random)).flat(),
  );
  const folder = emptyFolder(`store-${family}`);
  const file = writeArray(path.join(folder, "circles.f64"), xyr);
  await makeStore(path.join(folder, "store"), file, { perTile });
  return { xyr, random, store: await CircleStore.open(path.join(folder, "store")) };
}

describe.each(Object.keys(families))("%s", (family) => {
  test("the giants are the largest, and all others are in the buckets, once", async () => {
    const { xyr, store } = await stored(family);
    const everywhere = [-Infinity, -Infinity, Infinity, Infinity];
    const all = await store.within(everywhere);
    expect(all.known).toEqual(everywhere);
    const ids = [...store.giants.ids, ...all.ids];
    expect(ids.toSorted((a, b) => a - b)).toEqual([...Array(count).keys()]);
    const radii = [...store.giants.xyr, ...all.xyr].filter((_, k) => k % 3 === 2);
    expect(radii).toEqual(ids.map((id) => xyr[3 * id + 2]));
    expect(store.giants.ids).toHaveLength(perTile / 10);
    const [others, giants] = [radii.slice(perTile / 10), radii.slice(0, perTile / 10)];
    expect(Math.max(...others)).toBe(store.largest);
    expect(Math.min(...giants)).toBeGreaterThanOrEqual(store.largest);
    expect(store.mean).toBeCloseTo(radii.reduce((sum, r) => sum + r) / count, 9);
  });

  test("a rectangle gives all circles with centres in what it says is known", async () => {
    const { xyr, random, store } = await stored(family);
    const isGiant = new Set(store.giants.ids);
    const [xmin, ymin, xmax, ymax] = store.bounds;
    for (let k = 0; k < 50; ++k) {
      const x = [random(), random()].sort().map((share) => xmin + share * (xmax - xmin));
      const y = [random(), random()].sort().map((share) => ymin + share * (ymax - ymin));
      const { ids, known } = await store.within([x[0], y[0], x[1], y[1]]);
      expect(known[0]).toBeLessThanOrEqual(x[0]);
      expect(known[3]).toBeGreaterThanOrEqual(y[1]);
      const there = new Set(ids);
      const lost = [...Array(count).keys()].filter((id) => {
        const [cx, cy] = [xyr[3 * id], xyr[3 * id + 1]];
        const isIn = cx >= known[0] && cx <= known[2] && cy >= known[1] && cy <= known[3];
        // on the far line of a bucket it may be in the next one: nearer than the outside is not
        const isOnLine = cx === known[2] || cy === known[3];
        return isIn && !isOnLine && !isGiant.has(id) && !there.has(id);
      });
      expect(lost).toEqual([]);
    }
  });

  test("tiles have few circles and make up the window, also one that cuts them", async () => {
    const { store } = await stored(family);
    const [xmin, ymin, xmax, ymax] = store.bounds;
    const part = (a, b, share) => a + share * (b - a);
    const windows = [
      store.bounds,
      [part(xmin, xmax, 0.3), part(ymin, ymax, 0.1), part(xmin, xmax, 0.31), part(ymin, ymax, 0.9)],
    ];
    for (const window of windows) {
      const tiles = planTiles(store, window, perTile);
      const area = ([x0, y0, x1, y1]) => (x1 - x0) * (y1 - y0);
      const sum = tiles.reduce((all, tile) => all + area(tile.window), 0);
      expect(Math.abs(sum - area(window))).toBeLessThanOrEqual(1e-9 * area(window));
      if (family === "random")
        expect(Math.max(...tiles.map(({ size }) => size))).toBeLessThanOrEqual(perTile);
      for (const { halo } of tiles) expect(halo).toBeGreaterThan(0);
    }
    if (family === "line" || family === "copies") {
      expect(planTiles(store, store.bounds, perTile)).toEqual([]); // no area
    } else {
      const all = planTiles(store, store.bounds, perTile);
      expect(all.reduce((sum, { size }) => sum + size, 0)).toBe(count - perTile / 10);
    }
  });
});

test("files of a store that are not as long as its index says are refused", async () => {
  await stored("random");
  const home = path.join(emptyFolder("store-lengths"), "store");
  const whole = path.join(home, "../../store-random/store");
  for (const name of ["circles.f64", "starts.f64", "giants.f64"]) {
    const { size } = statSync(path.join(whole, name));
    for (const length of [0, 8, size - 32, size - 1, size + 32]) {
      rmSync(home, { recursive: true, force: true });
      cpSync(whole, home, { recursive: true });
      truncateSync(path.join(home, name), length);
      const file = path.join(home, name);
      await expect(CircleStore.open(home)).rejects.toThrow(
        `${file} has ${length} bytes, not ${size}`,
      );
    }
  }
  cpSync(whole, home, { recursive: true });
  const store = await CircleStore.open(home);
  truncateSync(path.join(home, "circles.f64"), 32 * (count / 2)); // while it is in use
  await expect(store.within(store.bounds)).rejects.toThrow("circles.f64 has become shorter");
  truncateSync(path.join(home, "index.json"), 20);
  await expect(CircleStore.open(home)).rejects.toThrow("index.json is damaged");
});

test("what is no file of triples, or an empty one, is refused", async () => {
  const folder = emptyFolder("store-refused");
  const file = path.join(folder, "circles.f64");
  writeArray(file, new Float64Array(4));
  const store = path.join(folder, "store");
  await expect(makeStore(store, file, { perTile })).rejects.toThrow("triples");
  writeArray(file, new Float64Array());
  await expect(makeStore(store, file, { perTile })).rejects.toThrow("is empty");
  expect(readdirSync(folder)).toEqual(["circles.f64"]);
});
