// Tiles are exactly the diagram of all circles, and the certificate that says so is sound.
import { describe, expect, test } from "@jest/globals";
import { Diagram } from "apollonius-diagram";
import { lackOf, tile } from "../../web/examples/cluster/tile.mjs";
import { generator } from "../wasm/support/random.mjs";

const side = 1000;
const giantCount = 50;

/** Kinds of circles: each from a random function, in the square. */
const families = {
  powerlaw: (random) => [side * random(), side * random(), 0.05 * (1 - random()) ** -0.7],
  clustered: (random) => [
    side * (0.2 + 0.1 * random() ** 3) + (random() < 0.1 ? 0.7 * side * random() : 0),
    side * random() ** 3,
    3 * random(),
  ],
  lattice: (_, k) => [((37 * k) % 100) * 10, Math.floor(k / 100) * 10 + 5, 2],
  negative: (random) => [side * random(), side * random(), -20 * random()],
};

/** Circles as `tile` asks for them, from memory; `known` is just what was asked for. */
function source(family, count, seed) {
  const random = generator(seed);
  const all = Array.from({ length: count }, (_, id) => ({ id, xyr: families[family](random, id) }));
  const bySize = all.toSorted((a, b) => b.xyr[2] - a.xyr[2]);
  const giants = new Set(bySize.slice(0, giantCount));
  const arrays = (circles) => ({
    xyr: Float64Array.from(circles.flatMap(({ xyr }) => xyr)),
    ids: Float64Array.from(circles, ({ id }) => id),
  });
  const rest = all.filter((circle) => !giants.has(circle));
  return {
    random,
    whole: new Diagram(all.flatMap(({ xyr }) => xyr)),
    giants: arrays([...giants]),
    largest: bySize[giantCount].xyr[2],
    async within(known) {
      const [xmin, ymin, xmax, ymax] = known;
      const isIn = ([x, y]) => x >= xmin && x <= xmax && y >= ymin && y <= ymax;
      return { ...arrays(rest.filter(({ xyr }) => isIn(xyr))), known };
    },
  };
}

const windows = Array.from({ length: 64 }, (_, k) => {
  const [x, y] = [(k % 8) * (side / 8), Math.floor(k / 8) * (side / 8)];
  return [x, y, x + side / 8, y + side / 8];
});

/** Points of a window: its corners, on its border, inside. */
function places([xmin, ymin, xmax, ymax], random, count) {
  const xy = [xmin, ymin, xmax, ymin, xmax, ymax, xmin, ymax];
  for (let k = 0; k < count; ++k) {
    xy.push(xmin + random() * (xmax - xmin), ymin + random() * (ymax - ymin));
    xy.push(xmin, ymin + random() * (ymax - ymin));
  }
  return xy;
}

describe.each(Object.keys(families))("%s", (family) => {
  test("64 tiles: the nearest circles, areas and neighbours of the diagram of all", async () => {
    const circles = source(family, 6000, 1);
    const { whole, random } = circles;
    const sums = new Float64Array(6000);
    for (const window of windows) {
      const { diagram, ids } = await tile(circles, window, 1);
      const xy = places(window, random, 100);
      expect(Array.from(diagram.findMany(xy), (k) => ids[k])).toEqual([...whole.findMany(xy)]);
      const own = diagram.voronoi(window);
      const cell = whole.voronoi(window);
      const all = cell.cellAreas();
      const differing = [];
      own.cellAreas().forEach((area, k) => {
        sums[ids[k]] += area;
        if (Math.abs(area - all[ids[k]]) > 1e-9) differing.push(ids[k]);
        if (area < 1e-6) return;
        const neighbours = [...own.neighbors(k)].map((site) => ids[site]).sort();
        if (neighbours.join() !== [...cell.neighbors(ids[k])].sort().join()) differing.push(ids[k]);
      });
      expect(differing).toEqual([]);
      diagram.dispose();
    }
    const areas = whole.voronoi([0, 0, side, side]).cellAreas();
    const worst = Math.max(...sums.map((area, id) => Math.abs(area - areas[id])));
    expect(worst).toBeLessThan(1e-8);
    expect(sums.reduce((sum, area) => sum + area)).toBeCloseTo(side * side, 5);
  });

  test("no halo that is too small is certified", async () => {
    // Windows of 40 to 0.04 of the side, with halos of 0 to some spacings. A cell that a wrong
    // certificate lets through is found by comparison with the diagram of all circles.
    const circles = source(family, 6000, 2);
    const { whole, random } = circles;
    let wrong = 0;
    let right = 0;
    for (let k = 0; k < 100; ++k) {
      const size = 40 * 10 ** (-3 * random());
      const [x, y] = [random() * (side - size), random() * (side - size)];
      const window = [x, y, x + size, y + size];
      const halo = 60 * random() ** 2;
      const around = [x - halo, y - halo, x + size + halo, y + size + halo];
      const { xyr, ids, known } = await circles.within(around);
      const diagram = new Diagram([...circles.giants.xyr, ...xyr]);
      const names = [...circles.giants.ids, ...ids];
      const xy = places(window, random, 100);
      const found = Array.from(diagram.findMany(xy), (id) => names[id]);
      const isRight = found.join() === [...whole.findMany(xy)].join();
      const isCertified = lackOf(diagram, window, known, circles.largest) < 0;
      if (isCertified) expect(isRight).toBe(true);
      wrong += !isRight;
      right += isCertified;
      diagram.dispose();
    }
    expect(wrong).toBeGreaterThan(5); // both are common, or this has tried nothing
    expect(right).toBeGreaterThan(5);
  });

  test("no point of the window lacks more than its border", async () => {
    // The lemma itself: points everywhere, against those on the border.
    const circles = source(family, 800, 3);
    const { random } = circles;
    for (const window of windows) {
      const [xmin, ymin, xmax, ymax] = window;
      const halo = 100 * random();
      const around = [xmin - halo, ymin - 2 * halo, xmax + halo / 2, ymax + halo];
      const { xyr, known } = await circles.within(around);
      const diagram = new Diagram([...circles.giants.xyr, ...xyr]);
      const most = lackOf(diagram, window, known, circles.largest);
      const xy = places(window, random, 200);
      const { distances } = diagram.nearestMany(xy);
      const lacks = distances.map((distance, k) => {
        const [x, y] = [xy[2 * k], xy[2 * k + 1]];
        const inside = Math.min(x - known[0], y - known[1], known[2] - x, known[3] - y);
        return distance + circles.largest - inside;
      });
      expect(Math.max(...lacks)).toBeLessThanOrEqual(most);
      diagram.dispose();
    }
  });
});

test("a circle far away that reaches in refutes small halos; a larger one has it", async () => {
  const small = (x, y) => [x, y, 0];
  const all = [small(0, 0), small(1, 0), small(0, 1), small(1, 1), [50, 0.5, 49]];
  const whole = new Diagram(all.flat());
  const circles = {
    giants: { xyr: new Float64Array(), ids: new Float64Array() },
    largest: 49,
    async within(known) {
      const [xmin, , xmax] = known;
      const ids = [...all.keys()].filter((id) => all[id][0] >= xmin && all[id][0] <= xmax);
      const xyr = Float64Array.from(ids.flatMap((id) => all[id]));
      return { xyr, ids: Float64Array.from(ids), known };
    },
  };
  const { diagram, ids, halo, rounds } = await tile(circles, [0, 0, 1, 1], 2);
  expect(rounds).toBeGreaterThan(1);
  expect(halo).toBeGreaterThan(49);
  expect(ids[diagram.find(0.9, 0.5)]).toBe(whole.find(0.9, 0.5));
  expect(whole.find(0.9, 0.5)).toBe(4);
});

test("of identical circles every tile takes the one with the smallest id", async () => {
  const random = generator(5);
  const circle = [10, 10, 1];
  const all = [...Array.from({ length: 40 }, () => [20 * random(), 20 * random(), 0])];
  for (const id of [7, 21, 30]) all[id] = circle;
  const circles = (order) => ({
    giants: { xyr: Float64Array.from(circle), ids: Float64Array.of(30) },
    largest: 1,
    async within() {
      const ids = order.filter((id) => id !== 30);
      const known = [-Infinity, -Infinity, Infinity, Infinity];
      return {
        xyr: Float64Array.from(ids.flatMap((id) => all[id])),
        ids: Float64Array.from(ids),
        known,
      };
    },
  });
  for (const order of [[...all.keys()], [...all.keys()].reverse()]) {
    const { diagram, ids } = await tile(circles(order), [9, 9, 11, 11], 1);
    expect(ids[diagram.find(10, 10)]).toBe(7);
  }
});

test("where all circles are giants, or all are known, there is nothing to certify", async () => {
  const everything = [-Infinity, -Infinity, Infinity, Infinity];
  const diagram = new Diagram([0, 0, 1]);
  expect(lackOf(diagram, [0, 0, 1, 1], everything, 5)).toBe(-Infinity);
  expect(lackOf(diagram, [0, 0, 1, 1], [-1, -1, 2, 2], -Infinity)).toBe(-Infinity);
  expect(lackOf(new Diagram(), [0, 0, 1, 1], [-1, -1, 2, 2], 5)).toBe(Infinity);
});
