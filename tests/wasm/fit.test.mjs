// Prescribed areas: reached, told, stopped and refused, at once and step by step between turns of
// the event loop. How they are found is tested in tests/geometry/fit_test.cpp.
import { runInNewContext } from "node:vm";
import { Diagram } from "../../build/packed/consumer.mjs";
import { validate } from "../../build/packed/diagnostics.mjs";
import { runInNode } from "./support/node.mjs";
import { generator } from "./support/random.mjs";
import { ringArea } from "./support/recorder.mjs";
import { expectRefusal, expectRejection } from "./support/refusal.mjs";

const random = generator(77);
const count = 200;
const centres = Array.from({ length: count }, () => [960 * random(), 500 * random()]);
const targets = Array.from({ length: count }, () => 0.5 + random());
const total = targets.reduce((sum, target) => sum + target, 0);
const built = () => Diagram.from(centres.map(([x, y], k) => [x, y, k % 40]));
const window = [0, 0, 960, 500];

test("areas in bounds and in a region are in proportion to the targets", () => {
  const hexagon = Array.from({ length: 6 }, (_, k) => [
    480 + 900 * Math.cos((k * Math.PI) / 3),
    250 + 900 * Math.sin((k * Math.PI) / 3),
  ]);
  const lake = [900, 480, 950, 480, 940, 490];
  for (const shape of [window, [hexagon, lake]]) {
    const diagram = built();
    expect(diagram.hiddenSize).toBeGreaterThan(0);
    const voronoi = diagram.voronoi(shape);
    const told = [];
    const fitted = voronoi.fitAreas(targets, { onIteration: (progress) => told.push(progress) });
    const { iterations, error, weights } = fitted;
    expect(fitted.converged).toBe(true);
    expect(fitted).not.toHaveProperty("reason");
    expect(error).toBeLessThanOrEqual(1e-6);
    expect(iterations).toBeLessThan(60);
    expect(told.map((progress) => progress.iterations)).toEqual(told.map((_, k) => k + 1));
    expect(told.at(-1).error).toBe(error);
    const whole = voronoi.cellAreas().reduce((sum, area) => sum + area, 0);
    for (let id = 0; id < count; ++id) {
      // By polygons, which know nothing of how it was found.
      let area = 0;
      for (const part of voronoi.cellParts(id, { tolerance: 1e-5, flat: true }))
        for (const ring of part) area += ringArea(ring);
      expect(Math.abs(area / ((targets[id] / total) * whole) - 1)).toBeLessThan(1e-4);
      const { x, y, r } = diagram.site(id);
      expect([x, y, r]).toEqual([...centres[id], weights[id]]);
    }
    expect(validate(diagram)).toBe(null);
  }
});

test("from the weights that were found no step is to be taken; nearby, few", () => {
  const voronoi = built().voronoi(window);
  const { weights } = voronoi.fitAreas(targets);
  expect(voronoi.fitAreas(targets, { start: weights }).iterations).toBe(0);
  const others = targets.map((target, k) => target * (1 + 0.01 * (k % 3)));
  expect(voronoi.fitAreas(others, { start: weights }).iterations).toBeLessThanOrEqual(5);
});

test("ids without a site do not matter, and are NaN", () => {
  const diagram = built();
  diagram.remove(3);
  const voronoi = diagram.voronoi(window);
  const { weights } = voronoi.fitAreas(targets.map((target, k) => (k === 3 ? -1 : target)));
  expect(weights.length).toBe(count);
  expect(weights[3]).toBeNaN();
});

test("none and one site", () => {
  const none = new Diagram().voronoi().fitAreas([]);
  const converged = { iterations: 0, error: 0, converged: true };
  expect(none).toStrictEqual({ ...converged, weights: new Float64Array(0) });
  const one = new Diagram([5, 5, 3]).voronoi().fitAreas([17]);
  expect(one).toStrictEqual({ ...converged, weights: Float64Array.of(3) });
});

test("targets may be a Map or an object, by id: the same weights", () => {
  const expected = built().voronoi(window).fitAreas(targets);
  const entries = [...targets.entries()];
  for (const given of [
    new Map(entries),
    new Map([...entries].reverse()), // in any order
    Object.fromEntries(entries),
    Object.assign(Object.create(null), targets),
    Float64Array.from(targets),
    { length: count, ...targets },
    runInNewContext("(entries) => Object.fromEntries(entries)")(entries),
  ])
    expect(built().voronoi(window).fitAreas(given)).toStrictEqual(expected);
});

test("targets that can be iterated, but not as a Map, are refused", () => {
  const view = built().voronoi(window);
  expectRefusal(
    () => view.fitAreas(new Set([1])),
    "bad-length",
    "targets has 1, expected pairs of an id and a number",
  );
});

test("targets may be another realm's Map", () => {
  const map = runInNewContext("(entries) => new Map(entries)")([...targets.entries()]);
  expect(built().voronoi(window).fitAreas(map).converged).toBe(true);
});

test("by id, targets are those of the sites: none of an id that was used before", () => {
  const [diagram, other] = [built(), built()];
  for (const one of [diagram, other]) one.removeMany([3, count - 1]);
  const entries = [...targets.entries()].filter(([id]) => diagram.has(id));
  const fitted = diagram.voronoi(window).fitAreas(new Map(entries));
  expect(fitted).toEqual(other.voronoi(window).fitAreas(targets));
  expect(fitted.weights.length).toBe(count);
  expect([fitted.weights[3], fitted.weights[count - 1]]).toEqual([NaN, NaN]);
  const again = diagram.voronoi(window);
  const extra = new Map([...entries, [3, 1]]);
  expectRefusal(() => again.fitAreas(extra), "unknown-site", "site 3 does not exist");
  const missing = new Map(entries.slice(0, -1));
  const [last] = entries.at(-1);
  expectRefusal(() => again.fitAreas(missing), "bad-target", `targets has none for site ${last}`);
  expect(new Diagram().voronoi().fitAreas(new Map()).converged).toBe(true);
  expect(new Diagram().voronoi().fitAreas({}).converged).toBe(true);
});

test("where only rounding is above the tolerance, weights are taken, unless strict", () => {
  const diagram = built();
  const voronoi = diagram.voronoi(window);
  const before = diagram.toBytes();
  const strict = { tolerance: 1e-300, strict: true };
  const { message } = expectRefusal(
    () => voronoi.fitAreas(targets, strict),
    "no-convergence",
    "more than the tolerance of 1e-300; the last places of weights and vertices do not allow less",
  );
  expect(Number(/are off by up to (\S+) of what/.exec(message)[1])).toBeLessThan(1e-12);
  expect(diagram.toBytes()).toEqual(before);
  const { error, converged, reason, weights } = voronoi.fitAreas(targets, { tolerance: 1e-300 });
  expect(converged).toBe(false);
  expect(reason).toBe("the last places of weights and vertices do not allow less");
  expect(error).toBeGreaterThan(1e-300);
  expect(error).toBeLessThan(1e-12);
  for (const id of diagram.ids()) expect(diagram.site(id).r).toBe(weights[id]);
  const areas = voronoi.cellAreas();
  for (let id = 0; id < count; ++id)
    expect(Math.abs(areas[id] / ((targets[id] / total) * 960 * 500) - 1)).toBeLessThan(1e-11);
  expect(validate(diagram)).toBeNull();
  // A fit that converges gives the weights that it gives without it.
  const usual = built().voronoi(window).fitAreas(targets);
  expect(built().voronoi(window).fitAreas(targets, { strict: true })).toStrictEqual(usual);
});

describe("the diagram stays as it is", () => {
  let diagram, voronoi, before;
  beforeEach(() => {
    diagram = built();
    voronoi = diagram.voronoi(window);
    before = diagram.toBytes();
  });
  afterEach(() => expect(diagram.toBytes()).toEqual(before));

  test("when the callback throws, which stops it", () => {
    const fault = new Error("mine");
    const steps = [];
    const onIteration = ({ iterations }) => {
      if (steps.push(iterations) === 3) throw fault;
    };
    expect(() => voronoi.fitAreas(targets, { onIteration })).toThrow(fault);
    expect(steps).toEqual([1, 2, 3]);
  });

  const refusals = [
    ["no-convergence", [targets, { maxIterations: 2 }], "after 2 steps areas are off by up to"],
    ["no-convergence", [targets, { maxIterations: 2 }], "more than the tolerance of 0.000001; "],
    [
      "no-convergence",
      [targets, { maxIterations: 2, tolerance: 1e-300 }],
      "more than the tolerance of 1e-300; more are not allowed",
    ],
    [
      "no-convergence",
      [targets, { tolerance: 1e-300, maxIterations: 60, strict: true }],
      "steps areas are off by",
    ],
    [
      "bad-length",
      [targets.slice(1)],
      "targets has 199 elements, expected 200: one for each id that was ever used",
    ],
    ["bad-length", [[...targets, 1]], "targets has 201 elements, expected 200"],
    ["bad-length", [[]], "targets has 0 elements, expected 200"],
    [
      "bad-length",
      [targets, { start: [1] }],
      "start has 1 elements, expected 200: one for each id that was ever used",
    ],
    ["bad-length", [undefined], "targets is undefined, expected an array of numbers"],
    ["bad-length", ["1"], 'targets is the string "1"'],
    ["unknown-site", [{ ...targets, 200: 1 }], "site 200 does not exist"],
    ["unknown-site", [new Map([...targets.entries(), [200, 1]])], "site 200 does not exist"],
    ["unknown-site", [{ ...targets, "-1": 1 }], "site -1 does not exist"],
    ["unknown-site", [{ ...targets, [2 ** 32]: 1 }], "site 4294967296 does not exist"],
    ["unknown-site", [new Map([...targets.entries(), [2 ** 32, 1]])], "site 4294967296 does not"],
    ["unknown-site", [{ ...targets, a: 1 }], 'site the string "a" does not exist: ids are whole'],
    ["unknown-site", [{ ...targets, "": 1 }], 'site the string "" does not exist'],
    ["unknown-site", [{ ...targets, " 7": 1 }], 'site the string " 7" does not exist'],
    ["unknown-site", [{ ...targets, 0.5: 1 }], "does not exist: ids are whole numbers"],
    ["unknown-site", [new Map([[null, 1]])], "site null does not exist: ids are whole numbers"],
    ["unknown-site", [new Map([[{}, 1]])], "site an object does not exist"],
    ["not-finite", [{ ...targets, 7: "1" }], 'targets[7] is the string "1"'],
    ["not-finite", [new Map([[7, 1n]])], "targets[7] is the bigint 1n"],
    ["not-finite", [targets.with(7, "1")], 'targets[7] is the string "1"'],
    ["bad-target", [{ ...targets, 7: 0 }], "targets[7] is 0"],
    ["bad-target", [{ ...targets, 7: Infinity }], "targets[7] is Infinity"],
    ["bad-target", [targets.with(7, 0)], "targets[7] is 0"],
    ["bad-target", [targets.with(7, -3)], "targets[7] is -3"],
    ["bad-target", [targets.with(7, NaN)], "targets[7] is NaN"],
    ["not-finite", [targets, { start: targets.with(7, NaN) }], "start[7] is NaN"],
    ["not-finite", [targets, { tolerance: NaN }], "tolerance is NaN"],
    ["out-of-range", [targets, { tolerance: 0 }], "tolerance is 0"],
    ["out-of-range", [targets, { maxIterations: 1.5 }], "maxIterations is 1.5"],
    ["bad-option", [targets, { onIteration: 7 }], "onIteration is 7"],
    ["bad-option", [targets, { strict: "yes" }], 'options.strict is the string "yes", expected'],
  ];
  test.each(
    refusals.map(([code, list, message]) => [code, message, list]),
  )("%s: %s", async (code, message, list) => {
    expectRefusal(() => voronoi.fitAreas(...list), code, message);
    await expectRejection(() => voronoi.fitAreasAsync(...list), code, message);
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
  const voronoi = diagram.voronoi(window);
  const onIteration = () => diagram.update(0, 1, 1, 1);
  expectRefusal(() => voronoi.fitAreas(targets, { onIteration }), "busy", "meanwhile");
  const disposing = built();
  expectRefusal(
    () => disposing.voronoi().fitAreas(targets, { onIteration: () => disposing.dispose() }),
    "disposed",
    "",
  );
});

describe("fitAreasAsync", () => {
  // Longer than a slice: then each step is followed by a turn of the event loop.
  const burn = () => {
    const end = performance.now() + 10;
    while (performance.now() < end);
  };
  const slowly = (diagram, options) =>
    diagram.voronoi(window).fitAreasAsync(targets, { onIteration: burn, ...options });

  test("the result of fitAreas, with the event loop's turns between its steps", async () => {
    const [diagram, other] = [built(), built()];
    const expected = other.voronoi(window).fitAreas(targets);
    let turns = 0;
    const timer = setInterval(() => ++turns, 0);
    const turnsAtSteps = [];
    const onIteration = () => {
      burn();
      turnsAtSteps.push(turns);
    };
    const fitted = await slowly(diagram, { onIteration });
    clearInterval(timer);
    expect(fitted).toStrictEqual(expected);
    expect(diagram.toBytes()).toEqual(other.toBytes());
    expect(turnsAtSteps.length).toBe(fitted.iterations);
    expect(turnsAtSteps.at(-1)).toBeGreaterThanOrEqual(fitted.iterations / 2);
  });

  test("options, targets by id, and small diagrams", async () => {
    for (const [given, options] of [
      [new Map(targets.entries()), {}],
      [targets, { tolerance: 1e-300 }],
      [targets, { start: targets, tolerance: 1e-3 }],
    ]) {
      const [diagram, other] = [built(), built()];
      const fitted = await diagram.voronoi(window).fitAreasAsync(given, options);
      expect(fitted).toStrictEqual(other.voronoi(window).fitAreas(given, options));
      expect(diagram.toBytes()).toEqual(other.toBytes());
    }
    expect((await new Diagram().voronoi().fitAreasAsync([])).weights.length).toBe(0);
    expect((await new Diagram([5, 5, 3]).voronoi().fitAreasAsync([17])).weights).toEqual(
      Float64Array.of(3),
    );
    // The value that the callback returns does not matter.
    expect((await slowly(built(), { onIteration: () => false })).converged).toBe(true);
  });

  test("its progress never falls, and ends at 1 before the diagram changes", async () => {
    for (const options of [{}, { tolerance: 1e-300 }, { tolerance: 1e6 }]) {
      const diagram = built();
      const before = diagram.toBytes();
      const [shares, errors, sharesAtSteps] = [[], [], []];
      const onIteration = ({ error }) => {
        burn();
        errors.push(error);
        sharesAtSteps.push(shares.at(-1) ?? 0);
      };
      const onProgress = (share) => {
        shares.push(share);
        if (share === 1) expect(diagram.toBytes()).toEqual(before);
      };
      const { iterations } = await slowly(diagram, { ...options, onIteration, onProgress });
      expect(shares).toEqual([...shares].sort((a, b) => a - b));
      expect(shares[0]).toBeGreaterThanOrEqual(0);
      expect(shares.at(-1)).toBe(1);
      // Each step that comes nearer than any before is seen.
      const better = errors.filter((error, k) => errors.slice(0, k).every((one) => one > error));
      expect(new Set(sharesAtSteps).size).toBeGreaterThanOrEqual(Math.min(better.length, 3));
      expect(errors.length).toBe(iterations);
    }
    const shares = [];
    const onProgress = (share) => shares.push(share);
    await new Diagram([5, 5, 3]).voronoi().fitAreasAsync([17], { onProgress });
    expect(shares).toEqual([1]);
  });

  test("what onProgress throws, and an abort in it, leave the diagram as it is", async () => {
    for (const at of [0, 1]) {
      const [diagram, fault] = [built(), new Error("mine")];
      const before = diagram.toBytes();
      const throws = (share) => {
        if (share >= at) throw fault;
      };
      await expect(slowly(diagram, { onProgress: throws })).rejects.toBe(fault);
      const controller = new AbortController();
      const { signal } = controller;
      const aborts = (share) => share >= at && controller.abort(fault);
      await expect(slowly(diagram, { signal, onProgress: aborts })).rejects.toBe(fault);
      expect(diagram.toBytes()).toEqual(before);
    }
  });

  const reason = new Error("enough");
  const expectAborted = async (diagram, start) => {
    const before = diagram.toBytes();
    await expect(start()).rejects.toBe(reason);
    expect(diagram.toBytes()).toEqual(before);
  };

  test("aborted before and between steps: the signal's reason, and no change", async () => {
    const first = built();
    await expectAborted(first, () => slowly(first, { signal: AbortSignal.abort(reason) }));
    for (const at of [1, 3]) {
      const [diagram, controller] = [built(), new AbortController()];
      const { signal } = controller;
      const onIteration = ({ iterations }) => {
        burn();
        if (iterations === at) setImmediate(() => controller.abort(reason));
      };
      await expectAborted(diagram, () => slowly(diagram, { signal, onIteration }));
    }
  });

  test("aborted in the midst of a slice, which the rest of the steps would not fill", async () => {
    const few = new Diagram([100, 100, 1, 300, 200, 20, 500, 50, 3]);
    const controller = new AbortController();
    const { signal } = controller;
    const onIteration = () => controller.abort(reason);
    await expectAborted(few, () =>
      few.voronoi(window).fitAreasAsync([1, 2, 3], { signal, onIteration }),
    );
  });

  test("a diagram that has changed meanwhile is busy and stays so, or gone", async () => {
    const changes = [
      (d) => d.update(0, 1, 1, 1),
      (d) => d.remove(5),
      (d) => d.insert(7, 7, 7),
      (d) => d.clear(),
      (d) => d.voronoi(window).fitAreas(targets),
    ];
    for (const change of changes) {
      const diagram = built();
      const fitting = slowly(diagram);
      change(diagram);
      const changed = diagram.toBytes();
      await expectRejection(() => fitting, "busy", "the diagram has changed meanwhile");
      expect(diagram.toBytes()).toEqual(changed);
      expect(validate(diagram)).toBeNull();
    }
    const disposed = built();
    const fitting = slowly(disposed);
    disposed.dispose();
    await expectRejection(() => fitting, "disposed", "disposed of");
  });

  test("of two at once the one that ends first wins; of other diagrams all do", async () => {
    const diagram = built();
    const both = [slowly(diagram), slowly(diagram)].map((fitting) =>
      fitting.then(
        ({ converged }) => converged,
        ({ code }) => code,
      ),
    );
    expect((await Promise.all(both)).sort()).toEqual(["busy", true]);
    expect(validate(diagram)).toBeNull();
    const all = await Promise.all([built(), built(), built()].map((one) => slowly(one)));
    expect(all[0].converged).toBe(true);
    expect(all[1]).toStrictEqual(all[0]);
    expect(all[2]).toStrictEqual(all[0]);
  });

  test("what its callback throws, and refusals of its own", async () => {
    const fault = new Error("mine");
    const onIteration = () => {
      throw fault;
    };
    const diagram = built();
    const before = diagram.toBytes();
    await expect(slowly(diagram, { onIteration })).rejects.toBe(fault);
    for (const [options, message] of [
      [{ signal: 7 }, "options.signal is 7, expected an AbortSignal"],
      [{ signal: null }, "options.signal is null"],
      [{ signals: 7 }, "options.signals is unknown, expected { tolerance, maxIterations, strict, "],
    ])
      await expectRejection(() => slowly(diagram, options), "bad-option", message);
    expect(diagram.toBytes()).toEqual(before);
    diagram.dispose();
    const voronoi = built().voronoi(window);
    voronoi.diagram.dispose();
    expectRefusal(() => voronoi.fitAreas(targets), "disposed", "has been disposed of");
    await expectRejection(() => voronoi.fitAreasAsync(targets), "disposed", "has been disposed of");
  });

  test("a diagram of which nobody else knows is not collected meanwhile", () => {
    const output = runInNode(
      `
      const { Diagram } = await import("apollonius-diagram");
      const collecting = setInterval(() => gc(), 0);
      const onIteration = () => {
        const end = performance.now() + 10;
        while (performance.now() < end);
      };
      const fit = () => new Diagram([100, 100, 1, 300, 200, 20, 500, 50, 3])
        .voronoi().fitAreasAsync([1, 2, 3], { onIteration });
      console.log(await fit().then(({ converged }) => converged, ({ code }) => code));
      clearInterval(collecting);`,
      ["--expose-gc"],
    );
    expect(output).toBe("true");
  });
});
