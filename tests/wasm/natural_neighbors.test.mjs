// Natural neighbours: against inserting the site, and as an interpolation.
import { Diagram } from "../../build/packed/consumer.mjs";
import { box, windows } from "./support/box_with_hole.mjs";
import { generator } from "./support/random.mjs";

/** What insertion takes from each cell, as a share of the new one. */
function expectedWeights(diagram, window, x, y, r) {
  const copy = Diagram.fromBytes(diagram.toBytes());
  const view = copy.voronoi(window);
  const before = view.cellAreas();
  const id = copy.insert(x, y, r);
  const after = view.cellAreas();
  return new Map(
    [...diagram.ids()]
      .map((other) => [other, (before[other] - after[other]) / after[id]])
      .filter(([, weight]) => weight > 1e-9),
  );
}

test.each(
  windows,
)("weights in %s are what insertion takes, and nothing changes", (_name, window) => {
  const random = generator(51);
  for (let run = 0; run < 40; ++run) {
    const circles = Array.from({ length: 1 + Math.floor(30 * random()) }, () => [
      100 * random(),
      60 * random(),
      run % 2 === 0 ? 0 : 4 * random(),
    ]);
    const diagram = Diagram.from(circles);
    const view = diagram.voronoi(window);
    const bytes = diagram.toBytes();
    for (let k = 0; k < 10; ++k) {
      const [x, y, r] = [100 * random(), 60 * random(), k % 3 === 0 ? 2 * random() : 0];
      const found = view.naturalWeights(x, y, r);
      const cover = circles.findIndex(([a, b, c]) => Math.hypot(x - a, y - b) <= c - r);
      if (cover >= 0) {
        expect(found.weights).toEqual(Float64Array.of(1));
        expect(diagram.find(x, y)).toBe(found.ids[0]);
        continue;
      }
      const expected = expectedWeights(diagram, window, x, y, r);
      expect(found.weights.reduce((a, b) => a + b)).toBeCloseTo(1, 12);
      found.ids.forEach((id, n) => {
        expect(found.weights[n]).toBeCloseTo(expected.get(id) ?? 0, 7);
        expected.delete(id);
      });
      expect([...expected.keys()]).toEqual([]);
    }
    expect(diagram.toBytes()).toEqual(bytes);
  }
});

test("a field that is linear is met, and values do not jump across edges", () => {
  const random = generator(52);
  const points = Array.from({ length: 200 }, () => [100 * random(), 60 * random(), 0]);
  const view = Diagram.from(points).voronoi([-200, -200, 300, 260]);
  const values = points.map(([x, y]) => 3 + 2 * x - y);
  const at = (x, y) => {
    const { ids, weights } = view.naturalWeights(x, y);
    return ids.reduce((sum, id, k) => sum + weights[k] * values[id], 0);
  };
  for (let k = 0; k < 50; ++k) {
    const [x, y] = [30 + 40 * random(), 20 + 20 * random()];
    expect(at(x, y)).toBeCloseTo(3 + 2 * x - y, 6); // Sibson: exact inside
    expect(Math.abs(at(x, y) - at(x + 1e-6, y))).toBeLessThan(1e-4);
  }
  points.slice(0, 20).forEach(([x, y], id) => expect(at(x, y)).toBe(values[id]));
});

test("without sites, outside of the window, and refused", () => {
  expect(new Diagram().voronoi(box).naturalWeights(1, 1)).toBe(null);
  const two = new Diagram([20, 30, 0, 80, 30, 0]);
  expect(two.voronoi(box).naturalWeights(1e6, 30)).toBe(null);
  expect(two.voronoi([0, 0, 10, 10]).naturalWeights(90, 30)).toBe(null);
  expect(new Diagram([20, 30, 0]).voronoi(box).naturalWeights(50, 30).weights).toEqual(
    Float64Array.of(1),
  );
  for (const [x, code] of [
    [NaN, "not-finite"],
    ["1", "not-finite"],
    [1e200, "out-of-range"],
  ])
    expect(() => two.voronoi(box).naturalWeights(x, 1)).toThrow(expect.objectContaining({ code }));
});
