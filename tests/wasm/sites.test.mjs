// Sites: inserting, removing, updating, ids, hidden sites.
import { Diagram } from "../../build/packed/consumer.mjs";
import { validate } from "../../build/packed/diagnostics.mjs";
import { graph } from "./support/graph.mjs";
import { randomCircles } from "./support/random.mjs";
import { expectRefusal } from "./support/refusal.mjs";

test("an empty diagram answers", () => {
  const diagram = new Diagram();
  expect([diagram.size, diagram.visibleSize, diagram.hiddenSize]).toEqual([0, 0, 0]);
  expect(diagram.find(1, 2)).toBe(-1);
  expect(diagram.nearest(1, 2)).toBeNull();
  expect(diagram.ids()).toEqual(new Uint32Array());
  expect(diagram.edges()).toEqual({ sites: new Uint32Array(), vertices: new Int32Array() });
  expect(diagram.vertices()).toEqual({
    xy: new Float64Array(),
    clearance: new Float64Array(),
    sites: new Uint32Array(),
  });
  expect(diagram.has(0)).toBe(false);
  expect(validate(diagram)).toBeNull();
});

test("the constructor gives ids in input order", () => {
  const diagram = new Diagram([0, 0, 1, 10, 0, 2, 0, 10, 3]);
  expect([...diagram.ids()]).toEqual([0, 1, 2]);
  expect(diagram.site(1)).toEqual({ x: 10, y: 0, r: 2 });
});

test("sites come back bit for bit", () => {
  const diagram = new Diagram();
  const id = diagram.insert(0.1, -1e-100, 1e100 / 3);
  expect(diagram.site(id)).toEqual({ x: 0.1, y: -1e-100, r: 1e100 / 3 });
});

test("r is 0 if left out, and may be negative", () => {
  const diagram = new Diagram();
  expect(diagram.site(diagram.insert(1, 2)).r).toBe(0);
  expect(diagram.site(diagram.insert(5, 2, -3)).r).toBe(-3);
  expect(validate(diagram)).toBeNull();
});

test("all kinds of number arrays are read", () => {
  const values = [0, 0, 1, 10, 0, 2];
  const kinds = [
    values,
    new Float64Array(values),
    new Float32Array(values),
    new Int8Array(values),
    new Uint16Array(values),
    { length: 6, ...values },
  ];
  for (const xyr of kinds) {
    const diagram = new Diagram();
    expect([...diagram.insertMany(xyr)]).toEqual([0, 1]);
    expect(diagram.site(1)).toEqual({ x: 10, y: 0, r: 2 });
  }
});

test("remove tells whether there was a site, and ids are used again", () => {
  const diagram = new Diagram([0, 0, 1, 10, 0, 1, 0, 10, 1]);
  expect(diagram.remove(1)).toBe(true);
  expect(diagram.remove(1)).toBe(false);
  expect(diagram.has(1)).toBe(false);
  expect([...diagram.ids()]).toEqual([0, 2]);
  expect(diagram.site(2)).toEqual({ x: 0, y: 10, r: 1 });
  expect(diagram.insert(5, 5, 1)).toBe(1);
});

test.each([
  [-1],
  [2 ** 32],
  [2 ** 32 + 1],
  [2 ** 32 - 1],
  [-(2 ** 60)],
  [3],
])("%p is no site's id", (id) => {
  const diagram = new Diagram([0, 0, 1, 10, 0, 1, 0, 10, 1]);
  expect(diagram.has(id)).toBe(false);
  expect(diagram.remove(id)).toBe(false);
  expect(diagram.removeMany([id])).toBe(0);
  expect(diagram.size).toBe(3);
});

// "0" of a form, or the NaN of a lost index, is an error sooner than a site that is not there.
test.each([
  [0.5],
  [NaN],
  [Infinity],
  ["0"],
  [null],
  [undefined],
  [{}],
  [[0]],
  [0n],
  [true],
])("%p is no id, and refused", (id) => {
  const diagram = new Diagram([0, 0, 1, 10, 0, 1, 0, 10, 1]);
  const wrong = "does not exist: ids are whole numbers, not strings or objects";
  expectRefusal(() => diagram.has(id), "unknown-site", wrong);
  expectRefusal(() => diagram.remove(id), "unknown-site", wrong);
  const many = () => diagram.removeMany([0, id, 1]);
  expect(expectRefusal(many, "unknown-site", wrong).message).toMatch(/^ids\[1\]: site /);
  const update = () => diagram.updateMany([0, id], [1, 1, 1, 2, 2, 2]);
  expect(expectRefusal(update, "unknown-site", wrong).message).toMatch(/^ids\[1\]: site /);
  expect(diagram.sites().xyr).toEqual(Float64Array.of(0, 0, 1, 10, 0, 1, 0, 10, 1));
});

test("removeMany counts what was there", () => {
  const diagram = new Diagram(randomCircles(50, 3));
  expect(diagram.removeMany([3, 4, 4, 1000, -1, 5])).toBe(3);
  expect(diagram.removeMany(new Uint32Array())).toBe(0);
  expect(diagram.removeMany(diagram.ids())).toBe(47);
  expect(diagram.size).toBe(0);
  expect(validate(diagram)).toBeNull();
});

test("update moves, resizes and keeps the id; without r it keeps the radius", () => {
  const diagram = new Diagram([0, 0, 1, 10, 0, 2, 0, 10, 3]);
  expect(diagram.update(1, 20, 5, 7)).toBe(diagram);
  expect(diagram.site(1)).toEqual({ x: 20, y: 5, r: 7 });
  diagram.update(1, 30, 5);
  expect(diagram.site(1)).toEqual({ x: 30, y: 5, r: 7 });
  expect(graph(diagram)).toEqual(graph(new Diagram([0, 0, 1, 30, 5, 7, 0, 10, 3])));
});

test("clear empties and starts ids from 0", () => {
  const diagram = new Diagram(randomCircles(50, 6));
  expect(diagram.clear()).toBe(diagram);
  expect(diagram.size).toBe(0);
  expect(diagram.insert(1, 1, 1)).toBe(0);
});

test("a covered circle is hidden until what covers it goes", () => {
  const diagram = new Diagram();
  const small = diagram.insert(1, 0, 1);
  const other = diagram.insert(100, 0, 1);
  expect(diagram.isHidden(small)).toBe(false);
  expect(diagram.coverOf(small)).toBe(-1);
  const large = diagram.insert(0, 0, 10);
  expect(diagram.isHidden(small)).toBe(true);
  expect(diagram.coverOf(small)).toBe(large);
  expect([...diagram.neighbors(small)]).toEqual([]);
  expect([diagram.size, diagram.visibleSize, diagram.hiddenSize]).toEqual([3, 2, 1]);
  diagram.remove(large);
  expect(diagram.isHidden(small)).toBe(false);
  expect([...diagram.neighbors(small)]).toEqual([other]);
});

test("a duplicate is a hidden site of its own", () => {
  const diagram = new Diagram([5, 5, 2, 5, 5, 2]);
  expect([diagram.size, diagram.visibleSize]).toEqual([2, 1]);
  diagram.remove(diagram.isHidden(0) ? 1 : 0);
  expect([diagram.size, diagram.visibleSize]).toEqual([1, 1]);
});
