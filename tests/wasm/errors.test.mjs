// Bad input: the code, the words, and that the diagram is as it was.
import { Diagram } from "../../build/packed/consumer.mjs";
import { validate } from "../../build/packed/diagnostics.mjs";
import { snapshot } from "./support/graph.mjs";
import { randomCircles } from "./support/random.mjs";
import { expectRefusal } from "./support/refusal.mjs";

function built() {
  const diagram = new Diagram(randomCircles(20, 21));
  diagram.insert(0, 0, 300); // hides some
  diagram.remove(7); // leaves a gap in the ids
  return diagram;
}

const NONE = 1000;
const cases = [
  // One number
  ["insert NaN", (d) => d.insert(NaN, 0, 0), "not-finite", "x is NaN"],
  ["insert Infinity", (d) => d.insert(0, Infinity, 0), "not-finite", "y is Infinity"],
  ["insert -Infinity", (d) => d.insert(0, 0, -Infinity), "not-finite", "r is -Infinity"],
  ["insert nothing", (d) => d.insert(), "not-finite", "x is undefined"],
  ["insert a string", (d) => d.insert(1, "2", 3), "not-finite", 'y is the string "2"'],
  ["insert null", (d) => d.insert(1, 2, null), "not-finite", "r is null"],
  ["insert a bigint", (d) => d.insert(1n, 2, 3), "not-finite", "x is the bigint 1n"],
  ["insert too large", (d) => d.insert(1e101, 0, 0), "out-of-range", "x is 1e+101"],
  ["update NaN", (d) => d.update(3, 0, NaN, 1), "not-finite", "y is NaN"],
  ["update a string", (d) => d.update(3, 0, 0, "1"), "not-finite", 'r is the string "1"'],
  ["update out of range", (d) => d.update(3, 0, 0, 1e300), "out-of-range", "r is 1e+300"],
  ["find NaN", (d) => d.find(NaN, 0), "not-finite", "x is NaN"],
  ["find nothing", (d) => d.find(1), "not-finite", "y is undefined"],
  ["find a string", (d) => d.find("1", 2), "not-finite", 'x is the string "1"'],
  ["find out of range", (d) => d.find(0, 1e150), "out-of-range", "y is 1e+150"],
  ["nearest Infinity", (d) => d.nearest(0, Infinity), "not-finite", "y is Infinity"],
  ["nearest out of range", (d) => d.nearest(1e200, 0), "out-of-range", "x is 1e+200"],

  // Arrays of numbers
  ["insertMany NaN", (d) => d.insertMany([1, 2, 3, 4, NaN, 6]), "not-finite", "xyr[4] is NaN"],
  [
    "insertMany NaN typed",
    (d) => d.insertMany(new Float32Array([1, 2, 3, 4, NaN, 6])),
    "not-finite",
    "xyr[4] is NaN",
  ],
  [
    "insertMany a string",
    (d) => d.insertMany([1, 2, 3, "4", 5, 6]),
    "not-finite",
    'xyr[3] is the string "4"',
  ],
  [
    "insertMany a hole",
    (d) => d.insertMany([1, 2, , 4, 5, 6]),
    "not-finite",
    "xyr[2] is undefined",
  ],
  [
    "insertMany bigints",
    (d) => d.insertMany(new BigInt64Array(3)),
    "not-finite",
    "xyr[0] is the bigint 0n",
  ],
  [
    "insertMany out of range",
    (d) => d.insertMany([1, 2, 3, 4, 5, 1e300]),
    "out-of-range",
    "xyr[5] is 1e+300",
  ],
  [
    "insertMany seven values",
    (d) => d.insertMany([1, 2, 3, 4, 5, 6, 7]),
    "bad-length",
    "expected a multiple of 3 values in xyr, got 7",
  ],
  ["insertMany undefined", (d) => d.insertMany(undefined), "bad-length", "xyr is undefined"],
  ["insertMany a number", (d) => d.insertMany(3), "bad-length", "xyr is 3"],
  [
    "insertMany a string for all",
    (d) => d.insertMany("123"),
    "bad-length",
    'xyr is the string "123"',
  ],
  ["insertMany no array", (d) => d.insertMany({ length: 1.5 }), "bad-length", "xyr is an object"],
  [
    "updateMany NaN",
    (d) => d.updateMany([1, 2], [1, 2, 3, 4, 5, NaN]),
    "not-finite",
    "xyr[5] is NaN",
  ],
  [
    "updateMany out of range",
    (d) => d.updateMany([1, 2], [1, 2, 3, 4, 5, 1e300]),
    "out-of-range",
    "xyr[5] is 1e+300",
  ],
  [
    "updateMany too short",
    (d) => d.updateMany([1, 2], [1, 2, 3]),
    "bad-length",
    "expected 6 values in xyr for 2 ids, got 3",
  ],
  [
    "updateMany four values",
    (d) => d.updateMany([1], [1, 2, 3, 4]),
    "bad-length",
    "expected a multiple of 3 values in xyr, got 4",
  ],
  ["updateMany no ids", (d) => d.updateMany(undefined, []), "bad-length", "ids is undefined"],
  ["removeMany no array", (d) => d.removeMany(5), "bad-length", "ids is 5"],
  ["findMany NaN", (d) => d.findMany([0, 0, NaN, 0]), "not-finite", "xy[2] is NaN"],
  ["findMany out of range", (d) => d.findMany([0, 0, 0, 1e123]), "out-of-range", "xy[3] is 1e+123"],
  [
    "findMany three values",
    (d) => d.findMany([0, 0, 0]),
    "bad-length",
    "expected a multiple of 2 values in xy, got 3",
  ],
  [
    "findMany an array to be filled",
    (d) => d.findMany([0, 0, 1, 1], new Float64Array(1)),
    "bad-option",
    "options is Float64Array(1), expected { maxDistance, filter }",
  ],

  // Ids
  ["site of a removed id", (d) => d.site(7), "unknown-site", "site 7 does not exist"],
  ["site of a negative id", (d) => d.site(-1), "unknown-site", "site -1 does not exist"],
  ["site of a fraction", (d) => d.site(1.5), "unknown-site", "site 1.5 does not exist"],
  ["site of a string", (d) => d.site("1"), "unknown-site", 'site the string "1" does not exist'],
  ["isHidden", (d) => d.isHidden(NONE), "unknown-site", "site 1000 does not exist"],
  ["coverOf", (d) => d.coverOf(NONE), "unknown-site", "site 1000 does not exist"],
  ["neighbors", (d) => d.neighbors(NONE), "unknown-site", "site 1000 does not exist"],
  ["update", (d) => d.update(NONE, 1, 2, 3), "unknown-site", "site 1000 does not exist"],
  ["update without r", (d) => d.update(NONE, 1, 2), "unknown-site", "site 1000 does not exist"],
  ["update of NaN", (d) => d.update(NaN, 1, 2, 3), "unknown-site", "site NaN does not exist"],
  [
    "updateMany",
    (d) => d.updateMany([1, NONE], [1, 2, 3, 4, 5, 6]),
    "unknown-site",
    "ids[1]: site 1000 does not exist",
  ],
  [
    "updateMany of a fraction",
    (d) => d.updateMany([0.5], [1, 2, 3]),
    "unknown-site",
    "ids[0]: site 0.5 does not exist",
  ],
];

test.each(cases)("%s", (_, call, code, message) => {
  const diagram = built();
  const before = snapshot(diagram);
  const error = expectRefusal(() => call(diagram), code, message);
  expect(error).toBeInstanceOf(Error);
  expect(error.name).toBe("ApolloniusError");
  expect(snapshot(diagram)).toBe(before);
  expect(validate(diagram)).toBeNull();
  expect(diagram.insert(0, 1, 2)).toBe(7); // the free id is still free
});

test.each([
  [[1, 2], "bad-length", "expected a multiple of 3 values in xyr, got 2"],
  [[1, 2, NaN], "not-finite", "xyr[2] is NaN"],
  [[1e200, 2, 3], "out-of-range", "xyr[0] is 1e+200"],
  [null, "bad-length", "xyr is null"],
])("the constructor refuses %p", (xyr, code, message) => {
  expect(() => new Diagram(xyr)).toThrow(
    expect.objectContaining({ code, message: expect.stringContaining(message) }),
  );
});

test("an array that calls back while it is read does no harm", () => {
  const diagram = built();
  const xyr = new Proxy([50, 60, 1], {
    get(target, key) {
      if (key === "1") diagram.insertMany(randomCircles(5000, 22));
      return target[key];
    },
  });
  const [id] = diagram.insertMany(xyr);
  expect(diagram.site(id)).toEqual({ x: 50, y: 60, r: 1 });
  expect(validate(diagram)).toBeNull();
});
