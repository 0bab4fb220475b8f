// Treemaps as users of d3-hierarchy make them: areas, nesting, shapes, padding, places.
import { hierarchy, stratify } from "d3-hierarchy";
import { treemap } from "../../build/packed/treemap.mjs";
import { isThorough } from "../support/effort.mjs";
import { generator } from "./support/random.mjs";
import { expectRefusal } from "./support/refusal.mjs";
import {
  areaOf,
  contains,
  deviationOf,
  distanceTo,
  flare,
  flat,
  polygonDeviationOf,
  randomTree,
  rootOf,
} from "./support/trees.mjs";

const box = [0, 0, 900, 500];
const star = Array.from({ length: 10 }, (_, k) => {
  const [angle, radius] = [(2 * Math.PI * k) / 10, k % 2 === 0 ? 100 : 45];
  return [radius * Math.cos(angle), radius * Math.sin(angle)];
});
const square = (x, y, side) => [
  [x, y],
  [x + side, y],
  [x + side, y + side],
  [x, y + side],
];
const frame = [square(0, 0, 100), square(30, 40, 25)]; // with a hole
const islands = [[square(0, 0, 100)], [square(130, 40, 25)]];
const shapes = [
  ["bounds", box, 450_000],
  ["a disc", { x: 3, y: -4, r: 10 }, 100 * Math.PI],
  ["a polygon", star, 5 * 100 * 45 * Math.sin(Math.PI / 5)],
  ["one with a hole", frame, 9375],
  ["two islands, as GeoJSON", { type: "MultiPolygon", coordinates: islands }, 10_625],
  ["a tiny one", [1e-9, 1e-9, 3e-9, 2e-9], 2e-18],
  // Places there are 1e-10 apart: 4e-9 of a leaf's area on its sides, at most.
  ["a far one", [1e6, 1e6, 1e6 + 1, 1e6 + 2], 2, 4e-9],
];

describe.each(["move", "stay"])("sites %s", (sites) => {
  const layout = () => treemap().sites(sites);

  test("flare: each cell has its share of the whole, and its polygon has the cell's area", () => {
    const root = layout().shape(box)(rootOf(flare));
    expect(root.leaves().length).toBe(220);
    expect(root.area).toBe(450_000);
    expect(deviationOf(root)).toBeLessThan(1e-6);
    expect(polygonDeviationOf(root)).toBeLessThan(1e-9);
    expect(root.descendants().every(({ fit }) => fit === null || fit.converged)).toBe(true);
  });

  test("cells are nested and disjoint: each place is in one leaf, and in all above it", () => {
    const root = layout().shape(box)(rootOf(flare));
    const random = generator(7);
    const tolerance = 2 ** -12 * Math.hypot(900, 500);
    let atBorders = 0;
    for (let k = 0; k < 100; ++k) {
      const place = [900 * random(), 500 * random()];
      const isAtBorder = root
        .descendants()
        .some(({ polygon }) => distanceTo(polygon, place) < tolerance);
      if (isAtBorder) ++atBorders;
      else {
        const [leaf, ...others] = root.leaves().filter(({ polygon }) => contains(polygon, place));
        expect(others).toEqual([]);
        expect(leaf.ancestors().every(({ polygon }) => contains(polygon, place))).toBe(true);
      }
    }
    expect(atBorders).toBeLessThan(10);
  });

  test.each(shapes)("areas in %s", (_, shape, area, rounding = 1e-9) => {
    const root = layout().shape(shape)(rootOf(randomTree(60, 3)));
    expect(root.area / area).toBeCloseTo(1, 9);
    expect(deviationOf(root)).toBeLessThan(1e-6);
    expect(polygonDeviationOf(root)).toBeLessThan(rounding);
  });

  test.each([
    ["very unequal", flat([1e-6, 1, 1e-3, 0.5])],
    ["from 1 to 1e-6", flat(Array.from({ length: 7 }, (_, k) => 10 ** -k))],
    ["lognormal, sigma 3", randomTree(200, 6, 3)],
    ["equal", flat(new Float64Array(97).fill(1))],
    ["two", flat([1, 3])],
  ])("areas of %s values", (_, data) => {
    const root = layout()(rootOf(data));
    expect(deviationOf(root)).toBeLessThan(1e-6);
  });

  test.each([2, 3, 4, 5, 7, 12])("%d equal values on islands that are as large", (count) => {
    const rings = Array.from({ length: 3 }, (_, k) => [square(120 * k, 0, 100)]);
    const root = layout().shape({ type: "MultiPolygon", coordinates: rings })(
      rootOf(flat(new Float64Array(count).fill(1))),
    );
    expect(deviationOf(root)).toBeLessThan(1e-6);
  });

  test("many leaves, in a tree and side by side", () => {
    const count = isThorough ? 3000 : 1000;
    for (const data of [
      randomTree(count, 8),
      flat(Float64Array.from({ length: count }, (_, k) => 1 + (k % 7))),
    ]) {
      const root = layout().shape(box)(rootOf(data));
      expect(deviationOf(root)).toBeLessThan(1e-6);
    }
  });

  test("the same tree and seed give the same bits, another seed another layout", () => {
    const results = [1, 1, 2].map((seed) => {
      const root = layout().seed(seed).shape(box)(rootOf(flare));
      return JSON.stringify(
        root.descendants().map(({ polygon, circle, area }) => [polygon, circle, area]),
      );
    });
    expect(results[0]).toBe(results[1]);
    expect(results[0]).not.toBe(results[2]);
  });
});

test("moved sites make rounder cells", () => {
  const roundness = (root) => {
    const all = root.leaves().map(({ area, polygon }) => {
      const length = polygon
        .slice(1)
        .reduce((sum, [x, y], k) => sum + Math.hypot(x - polygon[k][0], y - polygon[k][1]), 0);
      return (4 * Math.PI * area) / length ** 2;
    });
    return all.reduce((a, b) => a + b) / all.length;
  };
  const [moved, stayed] = ["move", "stay"].map((sites) =>
    roundness(treemap().shape(box).sites(sites)(rootOf(flare))),
  );
  expect(moved).toBeGreaterThan(stayed);
  expect(moved).toBeGreaterThan(0.77);
});

test("fields: centroid, circle, fit, and the path of the curved cell", () => {
  const root = treemap().shape(box)(rootOf(flare));
  expect([root.circle, root.centroid]).toEqual([null, [450, 250]]);
  const leaf = root.leaves()[0];
  expect(contains(leaf.polygon, leaf.centroid)).toBe(true);
  expect(contains(leaf.polygon, [leaf.circle.x, leaf.circle.y])).toBe(true);
  const { x, y, r } = leaf.label();
  expect(contains(leaf.polygon, [x, y])).toBe(true);
  expect(distanceTo(leaf.polygon, [x, y])).toBeCloseTo(r, 1);
  expect(distanceTo(leaf.polygon, leaf.centroid)).toBeLessThan(r / 0.999 + 0.1);
  expect(root.label()).toEqual({ x: expect.any(Number), y: 250, r: 250 });
  expect(leaf.fit).toBe(null);
  expect(root.fit).toMatchObject({ converged: true });
  const path = leaf.render(null, { digits: 2 });
  expect(path).toMatch(/^M[\d.,]+([LC][-\d.,]+)+Z$/);
  expect(path).toContain("C");
  const calls = [];
  const context = Object.fromEntries(
    ["moveTo", "lineTo", "bezierCurveTo", "closePath"].map((name) => [
      name,
      (...numbers) => calls.push([name, ...numbers]),
    ]),
  );
  expect(leaf.render(context)).toBe(undefined);
  // The drawing goes along the polygon.
  const ends = calls.filter(([name]) => name !== "closePath").map((call) => call.slice(-2));
  const tolerance = 2 ** -12 * Math.hypot(900, 500);
  expect(Math.max(...ends.map((end) => distanceTo(leaf.polygon, end)))).toBeLessThan(tolerance);
});

test("a disc's root is drawn as a circle", () => {
  const root = treemap().shape({ x: 1, y: 2, r: 3 })(rootOf(flat([1, 2])));
  const ends = [...root.render().matchAll(/([-\d.e]+),([-\d.e]+)(?=[CZ])/g)];
  expect(ends.length).toBeGreaterThan(7);
  for (const [, x, y] of ends) expect(Math.hypot(x - 1, y - 2)).toBeCloseTo(3, 9);
});

/** Gives places along a drawing, `each` of them on a curve, and the number of curves. */
function placesAlong(node, options, each) {
  const places = [];
  let curves = 0;
  node.render(
    {
      moveTo: (x, y) => places.push([x, y]),
      lineTo: (x, y) => places.push([x, y]),
      bezierCurveTo(x1, y1, x2, y2, x, y) {
        ++curves;
        const [x0, y0] = places.at(-1);
        for (let k = 1; k <= each; ++k) {
          const [t, s] = [k / each, 1 - k / each];
          const bezier = (a, b, c, d) =>
            s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
          places.push([bezier(x0, x1, x2, x), bezier(y0, y1, y2, y)]);
        }
      },
      closePath() {},
    },
    options,
  );
  return { places, curves };
}

test.each([1, 1e-6, 1e6])("tolerance of a drawing, in the shape's unit: size %d", (scale) => {
  // Very unequal values make arcs that turn far.
  const data = flat(Array.from({ length: 6 }, (_, k) => 8 ** -k));
  const { children } = treemap().size([900 * scale, 500 * scale])(rootOf(data));
  const usual = 2 ** -13 * scale * Math.hypot(900, 500);
  for (const leaf of children) {
    const { places, curves } = placesAlong(leaf, { tolerance: 1e-90 }, 16);
    const finest = [...places, places[0]];
    const chords = 1e-3 * scale; // error of the chords between the finest drawing's places
    let before = curves;
    expect(before).toBeLessThan(64 * 2 * children.length);
    for (const tolerance of [0.01, 0.1, 1, 10, 1000].map((share) => share * scale)) {
      const coarse = placesAlong(leaf, { tolerance }, 8);
      const off = Math.max(...coarse.places.map((place) => distanceTo(finest, place)));
      expect(off).toBeLessThan(tolerance + chords);
      expect(coarse.curves).toBeLessThanOrEqual(before);
      before = coarse.curves;
    }
    expect(before).toBe(0); // straight lines
    const byDefault = placesAlong(leaf, {}, 8);
    const off = Math.max(...byDefault.places.map((place) => distanceTo(finest, place)));
    expect(off).toBeLessThan(Math.min(usual, 0.003 * Math.sqrt(leaf.area)) + chords);
    expect(byDefault.curves).toBeGreaterThan(0);
    expect(byDefault.curves).toBeLessThan(curves / 4);
  }
});

test("label with an aspect: the largest ellipse, inside the cell", () => {
  const root = treemap().shape(star)(rootOf(flare));
  for (const leaf of root.leaves().filter((_, k) => k % 10 === 0)) {
    for (const aspect of [0.25, 1, 4]) {
      const { x, y, r } = leaf.label({ aspect });
      leaf.label({ aspect }).x = NaN; // it is the caller's
      expect(leaf.label({ aspect })).toEqual({ x, y, r });
      const squeezed = leaf.polygon.map(([px, py]) => [px / aspect, py]);
      const far = distanceTo(squeezed, [x / aspect, y]);
      const tolerance = (0.02 * Math.sqrt(leaf.area)) / Math.min(1, aspect);
      expect(contains(leaf.polygon, [x, y])).toBe(true);
      expect(Math.abs(far - r)).toBeLessThan(tolerance);
      for (const [px, py] of [leaf.centroid, [leaf.circle.x, leaf.circle.y]])
        expect(distanceTo(squeezed, [px / aspect, py])).toBeLessThan(r / 0.999 + tolerance);
    }
  }
});

test("nodes without a value have no cell, as their children have none; the others fill all", () => {
  const data = {
    name: "all",
    children: [
      { name: "a", size: 2 },
      { name: "none", size: 0 },
      {
        name: "empty",
        children: [
          { name: "x", size: 0 },
          { name: "y", size: 0 },
        ],
      },
      { name: "b", size: 1 },
    ],
  };
  const root = treemap()(hierarchy(data).sum(({ size = 0 }) => size));
  const [a, none, empty, b] = root.children;
  expect([a.area, b.area].map((area) => area.toFixed(6))).toEqual(["0.666667", "0.333333"]);
  for (const node of [none, empty, ...empty.children]) {
    expect(node).toMatchObject({
      area: 0,
      polygon: null,
      centroid: null,
      circle: null,
      fit: null,
    });
    expect([node.label(), node.label({ aspect: 2 }), node.render()]).toEqual([null, null, null]);
    expect(node.render({ moveTo() {}, lineTo() {}, bezierCurveTo() {}, closePath() {} })).toBe(
      undefined,
    );
    expectRefusal(() => node.render(null, { digits: -1 }), "out-of-range", "digits");
    expectRefusal(() => node.render(null, { tolerance: -1 }), "out-of-range", "tolerance");
    expectRefusal(() => node.label({ aspect: -1 }), "out-of-range", "aspect");
  }
  const nothing = treemap()(hierarchy({ name: "all" }).sum(() => 0));
  expect([nothing.polygon, nothing.area]).toEqual([null, 0]);
});

test("one leaf, only children, deep chains: they have all of their parent's cell", () => {
  const single = treemap().shape(box)(hierarchy({ name: "one" }).sum(() => 1));
  expect([single.area, single.polygon.length]).toEqual([450_000, 5]);
  let chain = flat([1, 2, 3]);
  for (let k = 0; k < 3000; ++k) chain = { name: `link ${k}`, children: [chain] };
  const root = treemap().shape({ x: 0, y: 0, r: 1 })(rootOf(chain));
  expect(root.height).toBe(3001);
  expect(deviationOf(root)).toBeLessThan(1e-6);
  const [only] = root.children;
  expect([only.polygon, only.fit, only.circle]).toEqual([root.polygon, null, null]);
});

test("deep levels of two children each: errors do not add up, however small cells become", () => {
  let data = { name: "end", size: 1 };
  let size = 1;
  for (let k = 0; k < 30; ++k) {
    data = { name: `level ${k}`, children: [data, { name: `side ${k}`, size }] };
    size *= 2;
  }
  const root = treemap().shape(box)(rootOf(data));
  expect(root.height).toBe(30);
  expect(root.value).toBe(2 ** 30);
  expect(deviationOf(root)).toBeLessThan(1e-6);
  expect(polygonDeviationOf(root)).toBeLessThan(1e-6);
});

test("value: read from the data as root.sum does, and put into the nodes", () => {
  const root = treemap().value(({ size }) => size)(hierarchy(flare));
  expect(root.value).toBe(rootOf(flare).value);
  expect(deviationOf(root)).toBeLessThan(1e-6);
  const table = [{ id: "r" }, { id: "a", of: "r", n: 1 }, { id: "b", of: "r", n: 3 }];
  const rows = stratify().parentId(({ of }) => of)(table);
  expect(treemap().value(({ n }) => n)(rows).children[1].area).toBeCloseTo(0.75, 6);
});

test("padding: children keep that distance from their parent's border, and fill the rest", () => {
  const padding = ({ children, data }) => (children && data.name !== "display" ? 3 : 0);
  const root = treemap().shape(box).padding(padding)(rootOf(flare));
  expect(root.area).toBe(450_000);
  root.each((node) => {
    if (!node.children) return;
    const width = padding(node);
    const sum = node.children.reduce((all, { area }) => all + area, 0);
    expect(sum).toBeLessThan(node.area * (1 + 1e-6));
    for (const child of node.children) {
      const target = (sum * child.value) / node.children.reduce((all, { value }) => all + value, 0);
      expect(Math.abs(child.area / target - 1)).toBeLessThan(1e-6);
      if (width === 0 || node.area < 40 * width * width) continue;
      for (const point of child.polygon)
        expect(distanceTo(node.polygon, point)).toBeGreaterThan(width * (1 - 1e-6));
    }
  });
  const inside = root.children.reduce((all, { area }) => all + area, 0);
  expect(inside / (894 * 494)).toBeCloseTo(1, 9);
});

// Padding takes a height away in steps, and rounding leaves 10^-16 of it: no room for cells.
test("padding that leaves nothing but rounding is halved, too", () => {
  const values = [107, 1.2, 1.03, 2.9, 34, 4.4];
  for (const [height, padding] of [
    [10, 2.5],
    [0.3, 0.05],
    [0.7, 0.7 / 6],
    [1.1, 0.55],
    [0.6, 0.1],
  ]) {
    const chain = { children: [{ children: [{ children: values.map((size) => ({ size })) }] }] };
    const root = treemap().shape([0, 0, 1000, height]).padding(padding)(rootOf(chain));
    for (const leaf of root.leaves()) expect(leaf.area).toBeGreaterThan(0);
  }
});

test("padding that a cell has no room for is halved until it has; holes grow", () => {
  const root = treemap().shape(box).padding(400)(rootOf(flat([1, 2])));
  const sum = root.children.reduce((all, { area }) => all + area, 0);
  expect(sum).toBeCloseTo(500 * 100, 3); // by 200
  const ring = treemap().shape(frame).padding(5)(rootOf(flat([1, 2, 3])));
  expect(ring.children.reduce((all, { area }) => all + area, 0)).toBeCloseTo(90 ** 2 - 35 ** 2, 3);
});

test("stay: sites are where they are told to be", () => {
  const places = { a: [100, 100], b: [700, 300], c: [400, 450], d: [401, 450] };
  const data = { name: "all", children: Object.keys(places).map((name) => ({ name, size: 1 })) };
  const layout = treemap()
    .shape(box)
    .sites("stay")
    .position(({ data: { name } }) => places[name]);
  const root = layout(rootOf(data));
  for (const {
    data: { name },
    circle: { x, y },
  } of root.children) {
    expect(x).toBeCloseTo(places[name][0], 9);
    expect(y).toBeCloseTo(places[name][1], 9);
  }
  expect(deviationOf(root)).toBeLessThan(1e-6);
});

test("places outside the parent's cell, or twice, are replaced by free ones nearby", () => {
  const layout = treemap()
    .shape(star)
    .sites("stay")
    .position(() => [300, 0]);
  const root = layout(rootOf(randomTree(40, 9)));
  expect(deviationOf(root)).toBeLessThan(1e-6);
  const nearest = Math.min(...root.children.map(({ circle: { x, y } }) => Math.hypot(x - 100, y)));
  expect(nearest).toBeLessThan(40);
});

test("a polygon is one closed ring, counter-clockwise, with its holes joined", () => {
  const root = treemap().shape(frame)(rootOf(flat([1])));
  const [leaf] = root.children;
  expect(leaf.polygon[0]).toEqual(leaf.polygon.at(-1));
  expect(areaOf(leaf.polygon)).toBeCloseTo(9375, 6);
  expect(contains(leaf.polygon, [40, 50])).toBe(false);
});
