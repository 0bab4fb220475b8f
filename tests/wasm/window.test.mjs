// The window of a view as a thing.
import { Diagram } from "../../build/packed/consumer.mjs";
import { randomCircles } from "./support/random.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const diagram = new Diagram(randomCircles(50, 181, 30));
const kSquare = [
  [0, 0],
  [10, 0],
  [10, 10],
  [0, 10],
];
const kHole = [
  [2, 2],
  [4, 2],
  [4, 4],
  [2, 4],
];
const sum = (numbers) => numbers.reduce((a, b) => a + b, 0);

test("bounds: area, centroid, what they contain", () => {
  const { window } = diagram.voronoi([0, 10, 30, 50]);
  expect(window).toMatchObject({ area: 1200, centroid: [15, 30], bounds: [0, 10, 30, 50] });
  expect(window.contains(0, 10)).toBe(true); // the border is part of it
  expect(window.contains(30, 50)).toBe(true);
  expect(window.contains(-1e-100, 20)).toBe(false);
  expect(window.contains(20, 50.00000000000001)).toBe(false);
});

test("a region with a hole", () => {
  const view = diagram.voronoi([kSquare, kHole]);
  const { window } = view;
  expect(window.bounds).toEqual([0, 0, 10, 10]);
  expect(window.area).toBe(96);
  const expected = (100 * 5 - 4 * 3) / 96;
  expect(window.centroid[0]).toBeCloseTo(expected, 12);
  expect(window.centroid[1]).toBeCloseTo(expected, 12);
  expect(sum(view.cellAreas())).toBeCloseTo(window.area, 9);
  for (const [x, y, isInside] of [
    [1, 1, true],
    [3, 3, false],
    [2, 3, true], // on the hole's border
    [4, 4, true],
    [0, 0, true],
    [10, 5, true],
    [5, 10, true],
    [5, 4, true], // level with the hole's corners
    [1, 2, true],
    [11, 10, false],
    [-1, 0, false],
    [-1, 4, false],
  ])
    expect([x, y, window.contains(x, y)]).toEqual([x, y, isInside]);
});

test("contains is exact, and even-odd", () => {
  const third = 1 / 3;
  const triangle = diagram.voronoi([
    [0, 0],
    [3, 1],
    [0, 1],
  ]).window;
  // 3 * (1/3) is rounded: the double 1/3 is below a third, the point left of the side or not
  expect(triangle.contains(1, third)).toBe(false);
  expect(triangle.contains(1, third + 2 ** -54)).toBe(true);
  expect(triangle.contains(1.5, 0.5)).toBe(true);
  const star = Array.from({ length: 5 }, (_, k) => [
    Math.cos((4 * Math.PI * k) / 5),
    Math.sin((4 * Math.PI * k) / 5),
  ]);
  const { window } = diagram.voronoi(star);
  expect(window.contains(0, 0)).toBe(false);
  expect(window.contains(0.9, 0)).toBe(true);
  const reversed = diagram.voronoi([...star].reverse()).window;
  expect(reversed.area).toBeCloseTo(window.area, 12);
});

test("what it refuses, and that it ends with its view", () => {
  const view = diagram.voronoi(kSquare);
  const { window } = view;
  expectRefusal(() => window.contains("1", 1), "not-finite", 'x is the string "1"');
  expectRefusal(() => window.contains(1, NaN), "not-finite", "y is NaN");
  expectRefusal(() => window.contains(1, 1e200), "out-of-range", "y is 1e+200");
  expect(() => {
    window.area = 7;
  }).toThrow(TypeError);
  expect(() => window.bounds.push(7)).toThrow(TypeError);
  view.dispose();
  expectRefusal(() => window.contains(1, 1), "disposed", "the view");
  expect(window.area).toBe(100);
  const other = new Diagram([1, 2, 3]);
  const { window: box } = other.voronoi();
  other.dispose();
  expectRefusal(() => box.contains(1, 1), "disposed", "the diagram");
});
