// Every call that takes or gives many, once on each kind of natural data: one far point, towns,
// all scales, few magnitudes. Answers agree with those of single calls, and areas add up.
// tests/diagram/work_of_batches_test.cpp counts the work.
import { ApolloniusError, Diagram } from "../../build/packed/consumer.mjs";
import { validate } from "../../build/packed/diagnostics.mjs";
import { tile } from "../../web/examples/cluster/tile.mjs";
import { generator, randomCircles } from "./support/random.mjs";

const count = 400;

/** Flat circles of [x, y, r] that `circle` makes of a generator of numbers in [0, 1). */
function circlesOf(seed, circle) {
  const random = generator(seed);
  return Float64Array.from(Array.from({ length: count }, () => circle(random)).flat());
}

function withOutlier(far) {
  const xyr = randomCircles(count, 5);
  xyr.set([far, far, 1], 3 * 200);
  return xyr;
}

function towns() {
  const random = generator(6);
  const centres = Array.from({ length: 8 }, () => [8e7 * random(), 8e7 * random()]);
  return circlesOf(7, (random) => {
    const [x, y] = centres[Math.floor(8 * random())];
    return [x + 100 * random(), y + 100 * random(), 4 * random()];
  });
}

function everyScale() {
  return circlesOf(8, (random) => {
    const distance = 2 ** (80 * random() - 40);
    const angle = 2 * Math.PI * random();
    return [distance * Math.cos(angle), distance * Math.sin(angle), 0.1 * distance * random()];
  });
}

function fewMagnitudes() {
  return circlesOf(9, (random) => {
    const x = (random() < 0.5 ? 1 : 1e99) * (0.1 + random());
    return [x, (random() < 0.5 ? 1e-99 : 1e50) * (0.1 + random()), 0];
  });
}

const sets = [
  ["an outlier at a hundred spreads", withOutlier(2e5)],
  ["an outlier at a billion spreads", withOutlier(2e12)],
  ["towns", towns()],
  ["every scale", everyScale()],
  ["few magnitudes", fewMagnitudes()],
];

/** The pairs of neighbours, in an order of their own. */
const pairsOf = (diagram) => {
  const { sites } = diagram.edges();
  const pairs = Array.from({ length: sites.length / 2 }, (_, k) =>
    [...sites.slice(2 * k, 2 * k + 2)].sort((a, b) => a - b).join(),
  );
  return pairs.sort().join(" ");
};
const rowsOf = (xyr) => Array.from({ length: count }, (_, k) => xyr.slice(3 * k, 3 * k + 3));

function boxOf(xyr) {
  const xs = xyr.filter((_, k) => k % 3 === 0);
  const ys = xyr.filter((_, k) => k % 3 === 1);
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

describe.each(sets)("%s", (_, xyr) => {
  const ids = Uint32Array.from({ length: count }, (_, k) => k);
  const half = count / 2;
  let diagram;
  beforeAll(() => {
    diagram = new Diagram(xyr);
  });
  afterAll(() => diagram.dispose());

  test("from, fromAsync, insertMany and inserting one by one make the same diagram", async () => {
    const expected = pairsOf(diagram);
    expect(validate(diagram)).toBeNull();
    const rows = rowsOf(xyr);
    const place = [(row) => row[0], (row) => row[1], (row) => row[2]];
    expect(pairsOf(Diagram.from(rows, ...place))).toBe(expected);
    expect(pairsOf(await Diagram.fromAsync(rows, ...place))).toBe(expected);
    const single = new Diagram();
    for (const row of rows) single.insert(...row);
    expect(pairsOf(single)).toBe(expected);
  });

  test("updateMany, removeMany and insertMany lead there, too", () => {
    const expected = pairsOf(diagram);
    const other = new Diagram(randomCircles(count, 10));
    other.updateMany(ids, xyr);
    expect(pairsOf(other)).toBe(expected);
    other.removeMany(ids.subarray(0, half));
    expect(validate(other)).toBeNull();
    other.insertMany(xyr.subarray(0, 3 * half));
    expect(validate(other)).toBeNull();
    expect(other.size).toBe(count);
    expect(other.visibleSize).toBe(diagram.visibleSize);
  });

  test("a snapshot can be edited", () => {
    const restored = Diagram.fromBytes(diagram.toBytes());
    for (let id = 0; id < 50; ++id) restored.remove(id);
    for (let k = 49; k >= 0; --k)
      expect(restored.insert(...xyr.subarray(3 * k, 3 * k + 3))).toBe(k);
    expect(validate(restored)).toBeNull();
    expect(pairsOf(restored)).toBe(pairsOf(diagram));
  });

  test("findMany answers as find does; also where only the queries are far", () => {
    const random = generator(11);
    const [xmin, ymin, xmax, ymax] = boxOf(xyr);
    const points = rowsOf(xyr).flatMap(([x, y], k) =>
      k % 2 ? [x, y] : [xmin + random() * (xmax - xmin), ymin + random() * (ymax - ymin)],
    );
    points.push(1e30, 1e30, -1e30, 0);
    const found = diagram.findMany(points);
    found.forEach((id, k) => expect(diagram.find(points[2 * k], points[2 * k + 1])).toBe(id));
    expect([...diagram.findMany(points.slice(0, 8))]).toEqual([...found.slice(0, 4)]);
  });

  test("areas, regions, drawings and lists", () => {
    const [xmin, ymin, xmax, ymax] = boxOf(xyr);
    const whole = diagram.voronoi([xmin, ymin, xmax, ymax]);
    const sum = (areas) => areas.reduce((a, b) => a + b, 0);
    const area = (xmax - xmin) * (ymax - ymin);
    expect(Math.abs(sum(whole.cellAreas()) / area - 1)).toBeLessThan(1e-9);
    expect(whole.render()).toMatch(/^M/);
    expect(whole.cellCentroids()).toHaveLength(2 * count);
    expect([...whole.cellPolygons()].length).toBeGreaterThan(0);
    expect(whole.toGeoJSON().features.length).toBeGreaterThan(0);
    expect(diagram.renderSites() === "").toBe(xyr.every((r, k) => k % 3 < 2 || r === 0));
    expect(diagram.hull().length).toBeGreaterThan(2);
    expect(diagram.vertices().xy.length).toBeGreaterThan(count);
    expect(diagram.search(xmin, ymin, xmax, ymax)).toHaveLength(count);
    expect(diagram.kNearest(xyr[0], xyr[1], count)).toHaveLength(count);
    // A side of 1e99 leaves nothing of one of 1e50 where it is slanted.
    if (xmax - xmin > 1e9 * (ymax - ymin)) return;
    const middle = [(xmin + xmax) / 2, (ymin + ymax) / 2];
    const diamond = diagram.voronoi([
      [
        [xmin, middle[1]],
        [middle[0], ymin],
        [xmax, middle[1]],
        [middle[0], ymax],
      ],
    ]);
    expect(Math.abs(sum(diamond.cellAreas()) / (area / 2) - 1)).toBeLessThan(1e-9);
    expect(diamond.render()).toMatch(/^M/);
  });

  test("areas are fitted, or it is said that they cannot be", () => {
    const few = xyr.slice(0, 3 * 50);
    const own = new Diagram(few);
    try {
      const { error } = own
        .voronoi(boxOf(few))
        .fitAreas(new Float64Array(50).fill(1), { strict: true });
      expect(error).toBeLessThan(0.01);
    } catch (error) {
      if (!(error instanceof ApolloniusError)) throw error;
      expect(error.code).toBe("no-convergence");
      expect(pairsOf(own)).toBe(pairsOf(new Diagram(few)));
    }
  });

  test("a tile is the diagram of all circles in its window", async () => {
    const [x, y] = xyr.subarray(3, 5);
    const reach = Math.max(Math.abs(x), Math.abs(y)) / 16;
    const window = [x - reach, y - reach, x + reach, y + reach];
    const within = async ([xmin, ymin, xmax, ymax]) => {
      const chosen = ids.filter((id) => {
        const [cx, cy] = xyr.subarray(3 * id, 3 * id + 2);
        return cx >= xmin && cx <= xmax && cy >= ymin && cy <= ymax;
      });
      return {
        ids: chosen,
        xyr: Float64Array.from([...chosen].flatMap((id) => [...xyr.subarray(3 * id, 3 * id + 3)])),
        known: [xmin, ymin, xmax, ymax],
      };
    };
    const largest = Math.max(...xyr.filter((_, k) => k % 3 === 2));
    const giants = { xyr: new Float64Array(0), ids: new Uint32Array(0) };
    const part = await tile({ within, giants, largest }, window, reach);
    const random = generator(12);
    for (let k = 0; k < 20; ++k) {
      const p = [x + reach * (2 * random() - 1), y + reach * (2 * random() - 1)];
      expect(part.ids[part.diagram.find(...p)]).toBe(diagram.find(...p));
    }
  });
});
