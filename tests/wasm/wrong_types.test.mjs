// Values of types that TypeScript refuses and JavaScript lets through: accepted and right, or an
// error with a code.
import { runInNewContext } from "node:vm";
import { Diagram } from "../../build/packed/consumer.mjs";
import { validate } from "../../build/packed/diagnostics.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const values = [0, 0, 1, 10, 0, 2];
const second = { x: 10, y: 0, r: 2 };

function shifted(bytes) {
  // Typed arrays at odd multiples of their element size; an address that is no multiple of 8 has to
  // be copied all the same.
  const array = new Float32Array(
    new ArrayBuffer(4 * (values.length + bytes)),
    4 * bytes,
    values.length,
  );
  array.set(values);
  return array;
}

function shared() {
  const array = new Float64Array(new SharedArrayBuffer(64), 8, values.length);
  array.set(values);
  return array;
}

function detached(array = new Float64Array(values)) {
  structuredClone(array, { transfer: [array.buffer] });
  return array;
}

/** A view of a buffer that grew or shrank after it was made. */
function resized(array, view, bytes) {
  const buffer = new ArrayBuffer(array.byteLength, { maxByteLength: 4 * array.byteLength });
  new array.constructor(buffer).set(array);
  const made = view(array.constructor, buffer);
  buffer.resize(bytes ?? array.byteLength);
  return made;
}
const shrunk = (array) =>
  resized(array, (Kind, buffer) => new Kind(buffer, 0, array.length), array.byteLength / 2);

test.each([
  ["a subarray", new Float64Array([9, ...values, 9]).subarray(1, 7)],
  ["an odd offset", shifted(1)],
  ["an odd offset of 12 bytes", shifted(3)],
  ["shared memory", shared()],
  ["clamped bytes", new Uint8ClampedArray(values)],
  ["another realm's array", runInNewContext("[0, 0, 1, 10, 0, 2]")],
  ["another realm's typed array", runInNewContext("new Float64Array([0, 0, 1, 10, 0, 2])")],
  [
    "a view of a buffer that grew",
    resized(new Float64Array(values), (Kind, buffer) => new Kind(buffer, 0, 6), 96),
  ],
  [
    "a view that follows its buffer",
    resized(new Float64Array([...values, 7, 7, 7]), (Kind, buffer) => new Kind(buffer), 48),
  ],
  [
    "shared memory that grew",
    (() => {
      const buffer = new SharedArrayBuffer(48, { maxByteLength: 96 });
      const array = new Float64Array(buffer, 0, 6);
      array.set(values);
      buffer.grow(96);
      return array;
    })(),
  ],
  ["an array-like object", { ...values, length: 6 }],
  [
    "a length-tracking view",
    new Float64Array(new ArrayBuffer(48, { maxByteLength: 96 })).fill(0).map((_, k) => values[k]),
  ],
])("%s is read rightly", (_, xyr) => {
  const diagram = new Diagram(xyr);
  expect(diagram.site(1)).toEqual(second);
  expect([...diagram.insertMany(xyr)]).toEqual([2, 3]);
  diagram.updateMany(
    new Uint32Array(new SharedArrayBuffer(8)).map((_, k) => k),
    xyr,
  );
  expect([...diagram.findMany(xyr)]).toEqual([...diagram.findMany(values)]);
  expect(validate(diagram)).toBeNull();
});

test("ids of all kinds, with offsets, shared, from another realm", () => {
  const kinds = [
    [0, 1],
    new Uint8Array([7, 0, 1]).subarray(1),
    new Float64Array([0, 1]),
    new Uint32Array([9, 0, 1]).subarray(1),
    new Uint32Array(new SharedArrayBuffer(8)).map((_, k) => k),
    runInNewContext("new Uint32Array([0, 1])"),
  ];
  for (const ids of kinds) {
    const diagram = new Diagram(values);
    diagram.updateMany(ids, [5, 5, 1, 20, 20, 2]);
    expect(diagram.site(1)).toEqual({ x: 20, y: 20, r: 2 });
    expect(diagram.removeMany(ids)).toBe(2);
  }
});

const cases = [
  // Detached buffers look empty.
  [
    "constructor",
    () => new Diagram(detached()),
    "bad-length",
    "xyr is a typed array whose buffer is detached",
  ],
  [
    "insertMany",
    (d) => d.insertMany(detached()),
    "bad-length",
    "xyr is a typed array whose buffer is detached",
  ],
  [
    "updateMany ids",
    (d) => d.updateMany(detached(new Uint32Array(2)), []),
    "bad-length",
    "ids is a typed array whose buffer is detached",
  ],
  [
    "updateMany xyr",
    (d) => d.updateMany([], detached()),
    "bad-length",
    "xyr is a typed array whose buffer is detached",
  ],
  [
    "removeMany",
    (d) => d.removeMany(detached(new Uint32Array(2))),
    "bad-length",
    "ids is a typed array whose buffer is detached",
  ],
  [
    "findMany",
    (d) => d.findMany(detached()),
    "bad-length",
    "xy is a typed array whose buffer is detached",
  ],
  // So do views whose buffer shrank below them.
  [
    "constructor",
    () => new Diagram(shrunk(new Float64Array(values))),
    "bad-length",
    "xyr is a typed array whose buffer is detached",
  ],
  [
    "insertMany",
    (d) => d.insertMany(shrunk(new Float32Array(values))),
    "bad-length",
    "xyr is a typed array whose buffer is detached",
  ],
  [
    "updateMany ids",
    (d) => d.updateMany(shrunk(new Uint32Array(2)), []),
    "bad-length",
    "ids is a typed array whose buffer is detached",
  ],
  [
    "updateMany xyr",
    (d) => d.updateMany([], shrunk(new Float64Array(values))),
    "bad-length",
    "xyr is a typed array whose buffer is detached",
  ],
  [
    "removeMany",
    (d) => d.removeMany(shrunk(new Uint8Array(2))),
    "bad-length",
    "ids is a typed array whose buffer is detached",
  ],
  [
    "findMany",
    (d) => d.findMany(shrunk(new Float64Array(values))),
    "bad-length",
    "xy is a typed array whose buffer is detached",
  ],
  [
    "from",
    () => Diagram.from(detached()),
    "bad-length",
    "xyr is a typed array whose buffer is detached",
  ],
  // Big integers
  ["constructor", () => new Diagram([1n, 2, 3]), "not-finite", "xyr[0] is the bigint 1n"],
  [
    "insertMany",
    (d) => d.insertMany(runInNewContext("new BigUint64Array(3)")),
    "not-finite",
    "xyr[0] is the bigint 0n",
  ],
  [
    "updateMany ids",
    (d) => d.updateMany([1n], [1, 2, 3]),
    "unknown-site",
    "ids[0]: site the bigint 1n does not exist: ids are whole numbers",
  ],
  ["findMany", (d) => d.findMany(new BigInt64Array(2)), "not-finite", "xy[0] is the bigint 0n"],
  ["nearest", (d) => d.nearest(0n, 0), "not-finite", "x is the bigint 0n"],
  ["site", (d) => d.site(1n), "unknown-site", "site the bigint 1n does not exist"],
  // Sparse arrays, and things that are no arrays
  ["constructor", () => new Diagram(new Array(3)), "not-finite", "xyr[0] is undefined"],
  ["updateMany", (d) => d.updateMany([0], [1, , 3]), "not-finite", "xyr[1] is undefined"],
  ["updateMany ids", (d) => d.updateMany([, 1], values), "unknown-site", "ids[0]"],
  ["findMany", (d) => d.findMany([1, , 3, 4]), "not-finite", "xy[1] is undefined"],
  ["findMany", (d) => d.findMany("12"), "bad-length", 'xy is the string "12"'],
  [
    "findMany",
    (d) => d.findMany(new DataView(new ArrayBuffer(16))),
    "bad-length",
    "xy is an object",
  ],
  ["findMany", (d) => d.findMany(new ArrayBuffer(16)), "bad-length", "xy is an object"],
  ["findMany", (d) => d.findMany(new Map()), "bad-length", "xy is an object"],
  ["insertMany", (d) => d.insertMany(() => {}), "bad-length", "xyr is a function"],
  [
    "insertMany",
    (d) =>
      d.insertMany([
        [0, 0, 1],
        [1, 1, 1],
        [2, 2, 2],
      ]),
    "not-finite",
    "xyr[0] is an array",
  ],
  ["removeMany", (d) => d.removeMany("0"), "bad-length", 'ids is the string "0"'],
  ["removeMany", (d) => d.removeMany(null), "bad-length", "ids is null"],
  ["insert", (d) => d.insert({ x: 1, y: 2, r: 3 }), "not-finite", "x is an object"],
  ["insert", (d) => d.insert(1, 2, true), "not-finite", "r is true"],
  ["insert", (d) => d.insert(1, 2, Symbol("r")), "not-finite", "r is Symbol(r)"],
  ["insert", (d) => d.insert(new Number(1), 2, 3), "not-finite", "x is an object"],
  // Lengths that no memory holds
  ["findMany", (d) => d.findMany({ length: 2 ** 50 }), "out-of-memory", "memory"],
  ["removeMany", (d) => d.removeMany({ length: 2 ** 50 }), "out-of-memory", "memory"],
  ["removeMany", (d) => d.removeMany({ length: 1 }), "unknown-site", "ids[0]: site undefined"],
  ["updateMany ids", (d) => d.updateMany({ length: 2 ** 50 }, []), "out-of-memory", "memory"],
  ["updateMany", (d) => d.updateMany([], { length: 3 * 2 ** 50 }), "out-of-memory", "memory"],
  ["insertMany", (d) => d.insertMany({ length: 2 ** 53 }), "bad-length", "xyr is an object"],
  ["findMany", (d) => d.findMany({ length: -2 }), "bad-length", "xy is an object"],
  // Items, accessors, options
  ["from", () => Diagram.from(null), "bad-length", "items is null"],
  ["from", () => Diagram.from(5), "bad-length", "items is 5"],
  ["from", () => Diagram.from("abc"), "bad-length", 'items is the string "abc"'],
  ["from", () => Diagram.from({ x: 1 }), "bad-length", "items is an object"],
  ["from", () => Diagram.from([{ x: 1, y: "2" }]), "not-finite", 'y of item 0 is the string "2"'],
  ["from", () => Diagram.from([[1, 2n]]), "not-finite", "y of item 0 is the bigint 2n"],
  [
    "from",
    () => Diagram.from([[1, 2]], "lon"),
    "bad-option",
    'x is the string "lon", expected a function',
  ],
  [
    "from",
    () => Diagram.from([[1, 2]], undefined, undefined, 5),
    "bad-option",
    "r is 5, expected a function",
  ],
  ["constructor", () => new Diagram([], { location: "walk" }), "bad-option", "expected { r }"],
  ["constructor", () => new Diagram([], { r: null }), "not-finite", "options.r is null"],
];

test("removeMany skips whole numbers that no site has, and refuses what is no id", () => {
  const diagram = new Diagram(values);
  expect(diagram.removeMany([-1, 2 ** 32, 2 ** 32 - 1, 7])).toBe(0);
  expect(diagram.removeMany(new Int8Array([-1, 7]))).toBe(0);
  for (const id of ["0", 0n, 0.5, NaN, null, undefined, {}, Symbol("0"), () => 0])
    expectRefusal(() => diagram.removeMany([1, id]), "unknown-site", "ids[1]: site ");
  expectRefusal(() => diagram.removeMany([1, , 0]), "unknown-site", "ids[1]: site undefined");
  expectRefusal(() => diagram.removeMany(new BigUint64Array(1)), "unknown-site", "the bigint 0n");
  expect([...diagram.ids()]).toEqual([0, 1]);
  expect(diagram.removeMany([1, 1, 7])).toBe(1);
  expect([...diagram.ids()]).toEqual([0]);
});

test.each(cases)("%s: %p", (_, call, code, message) => {
  const diagram = new Diagram(values);
  expectRefusal(() => call(diagram), code, message);
  expect(diagram.size).toBe(2);
  expect(validate(diagram)).toBeNull();
});
