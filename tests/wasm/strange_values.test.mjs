// Objects in place of numbers: what runs when they are converted, and strange values everywhere.
import { ApolloniusError, Diagram } from "../../build/packed/consumer.mjs";
import { validate } from "../../build/packed/diagnostics.mjs";
import { randomCircles } from "./support/random.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const built = () => new Diagram(randomCircles(50, 71));
const throwOwn = () => {
  throw new Error("the caller's own");
};

test.each(["xmin", "ymax", "diagram"])("a view's %s cannot be replaced", (name) => {
  const diagram = built(),
    view = diagram.voronoi();
  expect(() => {
    view[name] = { valueOf: () => diagram.dispose() };
  }).toThrow(TypeError);
  expect(() => {
    view[name] = { valueOf: throwOwn };
  }).toThrow(TypeError);
  expect(view.cellAreas().length).toBe(50);
});

test.each([
  [[{ valueOf: throwOwn }, 0, 1, 1]],
  [[0n, 0, 1, 1]],
  [[0, 0, NaN, 1]],
  [[]],
  [undefined],
])("a view is not made by hand with bounds %p", (bounds) => {
  expectRefusal(() => new (built().voronoi().constructor)(built(), bounds), "bad-bounds", "");
});

const strange = () => [
  NaN,
  -0,
  5e-324,
  2 ** 32,
  2 ** 32 - 1,
  -1,
  1.5,
  1e101,
  -Infinity,
  "0",
  0n,
  null,
  undefined,
  true,
  Symbol("0"),
  [0],
  [],
  {},
  () => 0,
  { valueOf: throwOwn },
  { [Symbol.toPrimitive]: throwOwn },
  new Date(0),
  new Proxy([], {}),
  Object.create(null),
  new Number(0),
];
const places = {
  insert: 3,
  remove: 1,
  update: 4,
  has: 1,
  site: 1,
  isHidden: 1,
  coverOf: 1,
  find: 3,
  nearest: 3,
  kNearest: 3,
  within: 3,
  pick: 4,
  pickMany: 3,
  search: 4,
  neighbors: 1,
  insertMany: 1,
  removeMany: 1,
  updateMany: 2,
  findMany: 3,
  voronoi: 1,
};
test.each(Object.entries(places))("%s with strange values in every place", (name, count) => {
  const diagram = built();
  for (let place = 0; place < count; ++place) {
    for (const value of strange()) {
      const values = new Array(count).fill(1);
      values[place] = value;
      try {
        diagram[name](...values);
      } catch (error) {
        expect(error).toBeInstanceOf(ApolloniusError);
      }
    }
  }
  expect(validate(diagram)).toBeNull();
});

// Some of them failed with a TypeError of the engine's.
test("every method of a view says what it was called on", async () => {
  const view = built().voronoi();
  const methods = Object.getOwnPropertyDescriptors(Object.getPrototypeOf(view));
  for (const [name, { value }] of Object.entries(methods)) {
    if (value === undefined || ["constructor", "dispose"].includes(name)) continue;
    for (const receiver of [undefined, {}, built()]) {
      const ask = () => {
        const answer = value.call(receiver, 0, undefined, undefined);
        return name === "cellPolygons" ? [...answer] : answer;
      };
      if (name.endsWith("Async")) await expect(ask()).rejects.toMatchObject({ code: "bad-option" });
      else expectRefusal(ask, "bad-option", "a method was called on");
    }
  }
});
