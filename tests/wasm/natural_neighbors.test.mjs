// Natural neighbours: against inserting the site, and as an interpolation.
import { Diagram } from "../../build/packed/consumer.mjs";
import { box, windows } from "./support/box_with_hole.mjs";
import { generator } from "./support/random.mjs";

/** Returns the parts that insertion takes from each cell, as shares of the new one. */
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
      const found = view.naturalWeights(x, y, { r });
      const cover = circles.findIndex(([a, b, c]) => Math.hypot(x - a, y - b) <= c - r);
      if (cover >= 0) {
        expect(found.weights).toEqual(Float64Array.of(1));
        expect(diagram.find(x, y)).toBe(found.ids[0]);
        continue;
      }
      const expected = expectedWeights(diagram, window, x, y, r);
      expect(found.weights.reduce((a, b) => a + b)).toBeCloseTo(1, 12);
      expect(found.weights.every((weight) => weight > 0)).toBe(true);
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

describe("interpolate", () => {
  const random = generator(53);
  const circles = Array.from({ length: 60 }, (_, k) => [
    100 * random(),
    60 * random(),
    k % 2 === 0 ? 0 : 4 * random(),
  ]);
  const diagram = Diagram.from(circles);
  const values = circles.map(([x, y]) => Math.sin(x / 9) + y / 20);
  const xy = Float64Array.from({ length: 4000 }, (_, k) => (k % 2 === 0 ? 104 : 64) * random() - 2);
  const points = Array.from({ length: xy.length / 2 }, (_, k) => [xy[2 * k], xy[2 * k + 1]]);

  test.each(
    windows,
  )("in %s says what naturalWeights says, and nothing changes", (_name, window) => {
    const view = diagram.voronoi(window);
    const bytes = diagram.toBytes();
    for (const r of [0, 1.5]) {
      const results = view.interpolate(values, xy, { r });
      expect(results.length).toBe(points.length);
      points.forEach(([x, y], k) => {
        if (!view.window.contains(x, y)) return expect(results[k]).toBeNaN();
        const { ids, weights } = view.naturalWeights(x, y, { r });
        const expected = ids.reduce((sum, id, n) => sum + weights[n] * values[id], 0);
        expect(results[k]).toBeCloseTo(expected, 10);
      });
    }
    expect(diagram.toBytes()).toEqual(bytes);
  });

  test("takes values by id in each form", () => {
    const view = diagram.voronoi(box);
    const expected = view.interpolate(values, xy);
    expect(view.interpolate(new Map(values.entries()), xy)).toEqual(expected);
    expect(view.interpolate({ ...values }, [...xy])).toEqual(expected);
    expect(view.interpolate(Float32Array.from(values), xy)[7]).toBeCloseTo(expected[7], 5);
    expect(view.interpolate(values, [])).toEqual(new Float64Array());
  });

  test("is the value of a site at its centre and in its circle", () => {
    const view = diagram.voronoi([-9, -9, 109, 69]);
    const centers = circles.flatMap((circle) => circle.slice(0, 2));
    view.interpolate(values, centers).forEach((value, id) => {
      if (!diagram.isHidden(id))
        expect(value).toBe(values[diagram.find(...circles[id].slice(0, 2))]);
    });
  });

  test("has no value next to a site that has none", () => {
    const view = diagram.voronoi(box);
    const id = diagram.find(50, 30);
    const some = view.interpolate(values.with(id, NaN), xy);
    const all = view.interpolate(values, xy);
    points.forEach(([x, y], k) => {
      const { ids, weights } = view.naturalWeights(x, y) ?? { ids: [], weights: [] };
      const uses = ids.some((other, n) => other === id && weights[n] > 0);
      expect(some[k]).toEqual(uses ? NaN : all[k]);
    });
  });

  test("refuses, and says what", () => {
    const view = diagram.voronoi(box);
    const failures = [
      [[[1], [1, 2]], "bad-length", "values has 1 elements, expected 60"],
      [[new Map([[0, 1]]), [1, 2]], "bad-length", "values has none for site 1"],
      [[new Map([[99, 1]]), [1, 2]], "unknown-site", "99"],
      [[values, [1, 2, 3]], "bad-length", "expected a multiple of 2 values in xy, got 3"],
      [[values, [1, 2, NaN, 3]], "not-finite", "xy[2] is NaN"],
      [[values, [1, 1e300]], "out-of-range", "xy[1]"],
      [[values, [1, 2], { r: NaN }], "not-finite", "options.r is NaN"],
      [[values, [1, 2], { radius: 1 }], "bad-option", "options.radius"],
    ];
    for (const [given, code, message] of failures)
      expect(() => view.interpolate(...given)).toThrow(
        expect.objectContaining({ code, message: expect.stringContaining(message) }),
      );
  });

  test("in slices: the same values, progress, an end", async () => {
    const view = diagram.voronoi(box);
    const many = Float64Array.from({ length: 60_000 }, () => 60 * random());
    const seen = [];
    const results = await view.interpolateAsync(values, many, { onProgress: (t) => seen.push(t) });
    view.interpolate(values, many).forEach((value, k) => {
      expect(results[k]).toBeCloseTo(value, 12);
    });
    expect(seen.at(-1)).toBe(1);
    expect(seen).toEqual([...seen].sort((a, b) => a - b));
    const stop = new AbortController();
    const aborted = view.interpolateAsync(values, many, {
      signal: stop.signal,
      onProgress: () => stop.abort(new Error("enough")),
    });
    await expect(aborted).rejects.toThrow("enough");
  });

  test("in slices: refused once the diagram has changed", async () => {
    const copy = Diagram.fromBytes(diagram.toBytes());
    const many = Float64Array.from({ length: 400_000 }, () => 60 * random());
    const promise = copy.voronoi(box).interpolateAsync(values, many);
    copy.remove(3);
    await expect(promise).rejects.toMatchObject({ code: "busy" });
  });
});
