// Prescribed areas: reached, told, stopped and refused. How they are found is tested in
// tests/geometry/fit_test.cpp.
import { Diagram } from "../../build/packed/consumer.mjs";
import { generator } from "./support/random.mjs";
import { ringArea } from "./support/recorder.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const random = generator(77);
const count = 200;
const centres = Array.from({ length: count }, () => [960 * random(), 500 * random()]);
const targets = Array.from({ length: count }, () => 0.5 + random());
const total = targets.reduce((sum, target) => sum + target, 0);
const built = () => Diagram.from(centres.map(([x, y], k) => [x, y, k % 40]));

test("areas in bounds and in a region are in proportion to the targets", () => {
  const hexagon = Array.from({ length: 6 }, (_, k) => [
    480 + 900 * Math.cos((k * Math.PI) / 3),
    250 + 900 * Math.sin((k * Math.PI) / 3),
  ]);
  const lake = [900, 480, 950, 480, 940, 490];
  for (const window of [
    [0, 0, 960, 500],
    [hexagon, lake],
  ]) {
    const diagram = built();
    expect(diagram.hiddenSize).toBeGreaterThan(0);
    const voronoi = diagram.voronoi(window);
    const told = [];
    const { iterations, error, weights } = voronoi.fitAreas(targets, {
      onIteration: (progress) => told.push(progress),
    });
    expect(error).toBeLessThanOrEqual(1e-6);
    expect(iterations).toBeLessThan(60);
    expect(told.map((progress) => progress.iterations)).toEqual(told.map((_, k) => k + 1));
    expect(told.at(-1).error).toBe(error);
    const whole = voronoi.cellAreas().reduce((sum, area) => sum + area, 0);
    for (let id = 0; id < count; ++id) {
      // By polygons, which know nothing of how it was found.
      const [first, ...rest] = voronoi.cellRegions(id, { tolerance: 1e-5 });
      let area = 0;
      for (const ring of [first, ...rest])
        for (const one of [ring, ...ring.holes]) area += ringArea(one);
      expect(Math.abs(area / ((targets[id] / total) * whole) - 1)).toBeLessThan(1e-4);
      const { x, y, r } = diagram.site(id);
      expect([x, y, r]).toEqual([...centres[id], weights[id]]);
    }
    expect(diagram.validate()).toBe(null);
  }
});

test("from the weights that were found no step is to be taken; nearby, few", () => {
  const voronoi = built().voronoi([0, 0, 960, 500]);
  const { weights } = voronoi.fitAreas(targets);
  expect(voronoi.fitAreas(targets, { start: weights }).iterations).toBe(0);
  const others = targets.map((target, k) => target * (1 + 0.01 * (k % 3)));
  expect(voronoi.fitAreas(others, { start: weights }).iterations).toBeLessThanOrEqual(5);
});

test("ids without a site do not matter, and are NaN", () => {
  const diagram = built();
  diagram.remove(3);
  const voronoi = diagram.voronoi([0, 0, 960, 500]);
  const { weights } = voronoi.fitAreas(targets.map((target, k) => (k === 3 ? -1 : target)));
  expect(weights.length).toBe(count);
  expect(weights[3]).toBeNaN();
});

test("none and one site", () => {
  const none = new Diagram().voronoi().fitAreas([]);
  expect(none).toEqual({ iterations: 0, error: 0, weights: new Float64Array(0) });
  const one = new Diagram([5, 5, 3]).voronoi().fitAreas([17]);
  expect(one).toEqual({ iterations: 0, error: 0, weights: Float64Array.of(3) });
});

describe("the diagram stays as it is", () => {
  const diagram = built();
  const voronoi = diagram.voronoi([0, 0, 960, 500]);
  const before = diagram.toBytes();
  afterEach(() => expect(diagram.toBytes()).toEqual(before));

  test("when it is stopped", () => {
    const steps = [];
    const stopped = voronoi.fitAreas(targets, {
      onIteration: ({ iterations }) => {
        steps.push(iterations);
        return iterations < 3;
      },
    });
    expect(stopped).toBe(null);
    expect(steps).toEqual([1, 2, 3]);
  });

  test("when the callback throws", () => {
    const fault = new Error("mine");
    const onIteration = () => {
      throw fault;
    };
    expect(() => voronoi.fitAreas(targets, { onIteration })).toThrow(fault);
  });

  test.each([
    ["no-convergence", [targets, { maxIterations: 2 }], "after 2 steps areas are off by up to"],
    [
      "no-convergence",
      [targets, { tolerance: 1e-300, maxIterations: 60 }],
      "steps areas are off by",
    ],
    ["bad-length", [targets.slice(1)], "lengths"],
    ["bad-length", [targets, { start: [1] }], "lengths"],
    ["bad-target", [targets.with(7, 0)], "targets[7] is 0"],
    ["bad-target", [targets.with(7, -3)], "targets[7] is -3"],
    ["bad-target", [targets.with(7, NaN)], "targets[7] is NaN"],
    ["not-finite", [targets, { start: targets.with(7, NaN) }], "start[7] is NaN"],
    ["not-finite", [targets, { tolerance: NaN }], "tolerance is NaN"],
    ["out-of-range", [targets, { tolerance: 0 }], "tolerance is 0"],
    ["out-of-range", [targets, { maxIterations: 1.5 }], "maxIterations is 1.5"],
    ["bad-option", [targets, { onIteration: 7 }], "onIteration is 7"],
  ])("%s", (code, list, message) => {
    expectRefusal(() => voronoi.fitAreas(...list), code, message);
  });
});

test("a centre outside the window, and two centres in one place, are refused by name", () => {
  const outside = new Diagram([1, 1, 0, 2, 2, 0, 50, 50, 0]).voronoi([0, 0, 3, 3]);
  expectRefusal(() => outside.fitAreas([1, 1, 1]), "bad-target", "the cell of site 2 is empty");
  const twins = new Diagram([1, 1, 0, 1, 1, 5]).voronoi([0, 0, 3, 3]);
  expectRefusal(() => twins.fitAreas([1, 1]), "bad-target", "the cell of site");
});

test("a callback that changes the diagram ends in an error", () => {
  const diagram = built();
  const voronoi = diagram.voronoi([0, 0, 960, 500]);
  const onIteration = () => diagram.update(0, 1, 1, 1);
  expectRefusal(() => voronoi.fitAreas(targets, { onIteration }), "busy", "meanwhile");
  const disposing = built();
  expectRefusal(
    () => disposing.voronoi().fitAreas(targets, { onIteration: () => disposing.dispose() }),
    "disposed",
    "",
  );
});
