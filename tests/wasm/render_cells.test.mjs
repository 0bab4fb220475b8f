// All cells' paths at once: the same as one by one.
import { Diagram } from "../../build/packed/consumer.mjs";
import { levels } from "../../build/packed/diagnostics.mjs";
import { randomCircles } from "./support/random.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const kBounds = [-900, -700, 1000, 800];
const diagram = new Diagram(randomCircles(3000, 171, 12));
diagram.insert(0, 0, 200); // hides some
diagram.removeMany([7, 8, 2999]);
const kStar = [
  [-800, -600],
  [900, -500],
  [100, 0],
  [950, 780],
  [0, 100],
  [-700, 700],
];

/** The cells by id, from a loop of single calls. */
function oneByOne(view, options) {
  return Array.from(view.cellAreas(), (_, id) =>
    view.diagram.has(id) ? view.renderCell(id, null, options) || null : null,
  );
}

const views = {
  bounds: diagram.voronoi(kBounds),
  "bounds away from all": diagram.voronoi([5000, 5000, 5001, 5001]),
  "a small window": diagram.voronoi([300, 300, 300.001, 300.001]),
  "a region": diagram.voronoi(kStar),
  "a distance": diagram.voronoi(kBounds, { maxDistance: 4 }),
  "a region and a distance": diagram.voronoi(kStar, { maxDistance: 4 }),
};

test.each(Object.entries(views))("in %s they are what renderCell gives", (_, view) => {
  for (const options of [
    { digits: 0 },
    { digits: 3 },
    { digits: 12 }, // too many for large coordinates, at least
    { digits: 15 },
    { digits: 2, tolerance: 20 },
    { digits: 5, tolerance: 1e-4 },
  ])
    expect(view.renderCells(null, options)).toEqual(oneByOne(view, options));
});

test("null for what has no cell in the window", () => {
  const paths = views.bounds.renderCells();
  expect(paths).toHaveLength(levels(diagram).length);
  expect([7, 8, 2999].map((id) => paths[id])).toEqual([null, null, null]);
  const areas = views.bounds.cellAreas();
  paths.forEach((path, id) => expect(path === null).toBe(areas[id] === 0));
  expect(new Diagram().voronoi().renderCells()).toEqual([]);
  expect(new Diagram([1, 2, 3]).voronoi().renderCells()).toEqual(["M0,0L960,0L960,500L0,500Z"]);
});

/** A context that writes its calls down. */
function recorder() {
  const pieces = [];
  const points =
    (letter) =>
    (...xy) => {
      pieces.push(`${letter}${xy}`);
    };
  return {
    moveTo: points("M"),
    lineTo: points("L"),
    bezierCurveTo: points("C"),
    closePath: points("Z"),
    beginPath() {
      pieces.length = 0;
    },
    text: () => pieces.join(""),
  };
}

test.each(Object.entries(views))("in %s, a context gets cell after cell", (_, view) => {
  for (const options of [undefined, { tolerance: 20 }]) {
    const context = recorder();
    const paths = new Array(view.cellAreas().length).fill(null);
    view.renderCells(context, (id) => (paths[id] = context.text()), options);
    expect(paths).toEqual(oneByOne(view, options));
  }
});

test("a context without beginPath gets one path of all cells", () => {
  const { beginPath, text, ...context } = recorder();
  const ids = [];
  views.bounds.renderCells(context, (id) => ids.push(id));
  const cells = oneByOne(views.bounds);
  expect(text()).toBe(ids.map((id) => cells[id]).join(""));
  expect(ids.length).toBe(cells.filter(Boolean).length);
});

test("what each throws ends the drawing; what is no context or function is refused", () => {
  const stop = new Error("enough");
  const seen = [];
  const each = (id) => {
    if (seen.push(id) === 3) throw stop;
  };
  expect(() => views["a distance"].renderCells(recorder(), each)).toThrow(stop);
  expect(seen).toHaveLength(3);
  expectRefusal(() => views.bounds.renderCells(recorder()), "bad-option", "each is undefined");
  expectRefusal(() => views.bounds.renderCells(null, () => {}), "bad-option", "options is a fun");
  expectRefusal(
    () => views.bounds.renderCells({ digits: 2 }),
    "bad-option",
    "options go behind it",
  );
  expectRefusal(() => views.bounds.renderCells("x"), "bad-option", "context is the string");
});

test("digits are by default what the tolerance needs", () => {
  const placesIn = (size, options) => {
    const view = new Diagram(randomCircles(50, 172, 0).map((c) => (c / 1000) * size)).voronoi([
      -size,
      -size,
      size,
      size,
    ]);
    const given = view.renderCells(null, options);
    const digits = [...Array(16).keys()].find(
      (places) =>
        String(given) === String(view.renderCells(null, { ...options, digits: places })) &&
        String(given) !== String(view.renderCells(null, { ...options, digits: places - 1 || 0 })),
    );
    return digits;
  };
  expect(placesIn(480)).toBe(2);
  expect(placesIn(1)).toBe(5);
  expect(placesIn(1e-3)).toBe(8);
  expect(placesIn(480, { tolerance: 1e-4 })).toBe(5);
});

test("numbers are written as JavaScript writes them", () => {
  // Small ones with exponents, halves upwards, no -0, none with a superfluous 0.
  const xs = [0, 5e-7, -5e-7, 1.5e-6, 2.5e-9, -0.5, 1e-3, 123456.75, -99999.5, 1e-15, 7e-8, 0.1];
  for (const digits of [0, 1, 3, 6, 7, 8, 9, 10, 15])
    for (const x of xs)
      for (const size of [1, 1e-5]) {
        const view = new Diagram([x, x, 1]).voronoi([x, x, x + size, x + 2 * size]);
        expect(view.renderCells(null, { digits })).toEqual(oneByOne(view, { digits }));
      }
  const far = new Diagram([1e99, 0, 1]).voronoi([1e99, 0, 2e99, 1e99]);
  expect(far.renderCells()).toEqual(oneByOne(far, { digits: 0 }));
});

test("in portions, after changes, and in any order of insertion", () => {
  const many = new Diagram(randomCircles(12_000, 173, 2));
  const view = many.voronoi([-1000, -1000, 1000, 1000]);
  expect(view.renderCells(null, { digits: 2 })).toEqual(oneByOne(view, { digits: 2 }));
  for (let id = 0; id < 3000; id += 3) many.update(id, id / 3 - 500, (id * 7919) % 997, 1);
  many.removeMany(Uint32Array.from({ length: 2000 }, (_, k) => 6000 + k));
  expect(view.renderCells(null, { digits: 2 })).toEqual(oneByOne(view, { digits: 2 }));
});
