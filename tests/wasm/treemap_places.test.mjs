// Places that a layout chooses for its sites: inside the window, none twice, however thin it is.
import { treemap } from "../../build/packed/treemap.mjs";
import { isThorough } from "../support/effort.mjs";
import { expectRefusal } from "./support/refusal.mjs";

/** Mulberry32: a seed that found a fault finds it again. */
const randomOf = (seed) => () => {
  seed = (seed + 0x6d2b79f5) >>> 0;
  let t = Math.imul(seed ^ (seed >>> 15), seed | 1);
  t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
  return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
};

const shapes = {
  rectangle: [0, 0, 960, 500],
  box: [
    [
      [0, 0],
      [960, 0],
      [960, 500],
      [0, 500],
    ],
  ],
  quadrilateral: [
    [
      [110, 16],
      [-255, 188],
      [-293, -86],
      [140, -177],
    ],
  ],
  thin: [
    [
      [0, 0],
      [1000, 300],
      [1000, 304],
      [0, 8],
    ],
  ],
  star: [
    [
      [0, -100],
      [22, -31],
      [95, -31],
      [36, 12],
      [59, 81],
      [0, 38],
      [-59, 81],
      [-36, 12],
      [-95, -31],
      [-22, -31],
    ],
    [
      [-5, -5],
      [5, -5],
      [0, 6],
    ],
  ],
  disc: { x: 3, y: 4, r: 50 },
};

function flatRoot(leaves, seed) {
  const random = randomOf(seed);
  const children = Array.from({ length: leaves }, () => ({
    data: {},
    value: 1 + 99 * random() ** 3,
  }));
  return { data: {}, value: children.reduce((sum, { value }) => sum + value, 0), children };
}

function nestedRoot(groups, seed) {
  const random = randomOf(seed);
  const children = Array.from({ length: groups }, () => {
    const leaves = Array.from({ length: groups }, () => ({
      data: {},
      value: 1 + 99 * random() ** 3,
    }));
    return { data: {}, value: leaves.reduce((sum, { value }) => sum + value, 0), children: leaves };
  });
  return { data: {}, value: children.reduce((sum, { value }) => sum + value, 0), children };
}

/** The largest error of the leaves' areas, as a share of the area that a leaf is to have. */
function deviationOf(root) {
  const leaves = root.children.flatMap((child) => child.children ?? [child]);
  return leaves.reduce(
    (most, { area, value }) =>
      Math.max(most, Math.abs((area * root.value) / (value * root.area) - 1)),
    0,
  );
}

// Means of two evenly spaced samples were the only sample of another site.
test.each([5, 14, 18, 21])("3000 leaves, seed %i: no two sites get one place", (seed) => {
  const root = flatRoot(3000, seed * 7919 + 3000);
  const shape = seed % 2 === 1 ? shapes.box : shapes.quadrilateral;
  treemap().shape(shape).sites("stay").seed(seed)(root);
  expect(deviationOf(root)).toBeLessThan(1e-6);
});

test("54 groups of 54 leaves: no two sites get one place", () => {
  const root = nestedRoot(54, 21 * 977 + 54);
  treemap().shape(shapes.rectangle)(root);
  expect(deviationOf(root)).toBeLessThan(1e-6);
});

test.each(Object.entries(shapes))(
  "seeded layouts in a %s have all areas",
  (_, shape) => {
    for (let seed = 0; seed < (isThorough ? 333 : 1); ++seed) {
      const size = 1000 + Math.floor(4000 * randomOf(seed)());
      const root =
        seed % 2 === 0 ? flatRoot(size, seed) : nestedRoot(Math.floor(Math.sqrt(size)), seed);
      treemap().shape(shape).sites("stay").seed(seed)(root);
      expect([seed, deviationOf(root) < 1e-6]).toEqual([seed, true]);
    }
  },
  10_000_000,
);

test("two leaves in shapes of every aspect: areas, or a typed error", () => {
  for (const thin of [1e-3, 1e-6, 1e-9, 1e-12, 1e-14, 1e-20, 1e-30]) {
    const shape = [0, 0, 1, thin];
    const root = flatRoot(2, 5);
    if (thin > 1e-13) {
      treemap().shape(shape)(root);
      expect(deviationOf(root)).toBeLessThan(1e-6);
    } else {
      expectRefusal(() => treemap().shape(shape)(root), "no-convergence", "vanished by rounding");
    }
  }
});

/** Rectangles [x0, y0, x1, y1] as the parts of a MultiPolygon. */
const islandsOf = (boxes) =>
  boxes.map(([x0, y0, x1, y1]) => [
    [
      [x0, y0],
      [x1, y0],
      [x1, y1],
      [x0, y1],
    ],
  ]);

// Rows at even distances missed both strips.
describe.each(["stay", "move"])("islands that are thin and far apart, sites that %s", (sites) => {
  test.each([
    ["strips above each other", 2, 1e-3],
    ["strips above each other", 30, 1e-3],
    ["strips beside each other", 30, 1e-3],
    ["a strip above a tower", 2, 1e-3],
  ])("%s, %i leaves, %d thick", (kind, leaves, thin) => {
    const boxes = {
      "strips above each other": [
        [0, 0, 1, thin],
        [0, 1, 1, 1 + thin],
      ],
      "strips beside each other": [
        [0, 0, thin, 1],
        [1, 0, 1 + thin, 1],
      ],
      "a strip above a tower": [
        [0, 0, thin, 1000],
        [0, 1001, 1, 1001 + thin],
      ],
    };
    const root = flatRoot(leaves, 5);
    treemap().shape(islandsOf(boxes[kind])).sites(sites)(root);
    expect(deviationOf(root)).toBeLessThan(1e-6);
  });
});

test.each([Infinity, 2 ** 53, 1001])("rounds(%d) is refused", (rounds) => {
  expectRefusal(() => treemap().rounds(rounds), "out-of-range", "expected at most 1000");
});
