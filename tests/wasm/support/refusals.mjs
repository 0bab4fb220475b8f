// Refused arguments, by their kind; for calls.mjs.
import { Diagram } from "../../../build/packed/consumer.mjs";

export const NONE = 1000; // an id that no site has
export const bounds = [-100, -100, 100, 100];
export const inWindow =
  (use) =>
  (d, ...values) =>
    use(d.voronoi(bounds), ...values);

const equal = (d) => new Array(d.voronoi(bounds).cellAreas().length).fill(1);
/** In a window that holds all centres. */
export const fitBy =
  (name) =>
  (d, { targets = equal(d).map((_, k) => 1 + (k % 2)), ...options } = {}) =>
    d.voronoi([-1e4, -1e4, 1e4, 1e4])[name](targets, options);

// Each takes a call with one argument left open, and returns refusals: [code, call, text in the
// message].
export const number = (name, call) => [
  ["not-finite", (d) => call(d, NaN), `${name} is NaN`],
  ["not-finite", (d) => call(d, "7"), `${name} is the string "7"`],
  ["out-of-range", (d) => call(d, -1e101), `${name} is -1e+101`],
];
/** For calls that accept whole numbers without a site. */
export const wholeNumber = (call) => [
  ["unknown-site", (d) => call(d, "0"), 'site the string "0" does not exist: ids are whole numb'],
  ["unknown-site", (d) => call(d, 0.5), "site 0.5 does not exist: ids are whole numbers, not"],
  ["unknown-site", (d) => call(d, null), "site null does not exist: ids are whole numbers, not"],
];
export const id = (call) => [
  ["unknown-site", (d) => call(d, NONE), "site 1000 does not exist"],
  ...wholeNumber(call),
];
export const numbers = (name, multiple, call) => [
  ["not-finite", (d) => call(d, [1, 2, 3, 4, NaN, 6]), `${name}[4] is NaN`],
  ["out-of-range", (d) => call(d, [1, 2, 3, 1e200, 5, 6]), `${name}[3] is 1e+200`],
  [
    "bad-length",
    (d) => call(d, [1, 2, 3, 4, 5, 6, 7]),
    `expected a multiple of ${multiple} values in ${name}, got 7`,
  ],
  ["bad-length", (d) => call(d, 7), `${name} is 7`],
];
// 2^29 + 1 sites and as many as JavaScript can count, of which none is read.
export const tooMany = (name, perSite, call) =>
  [2 ** 29 + 1, 2 ** 51].map((count) => [
    "too-large",
    (d) =>
      call(d, {
        length: perSite * count,
        get 0() {
          throw new Error("read");
        },
      }),
    `${name} holds ${count} sites, expected at most 2^29`,
  ]);
export const window = (call) => [
  ["bad-bounds", (d) => call(d, [0, 0, 0, 5]), "bounds are [0, 0, 0, 5]"],
  [
    "bad-bounds",
    (d) => call(d, [0, 0, 5]),
    "bounds is an array of 3, expected [xmin, ymin, xmax, ymax]",
  ],
  ["bad-bounds", (d) => call(d, [0, 0, 5, "5"]), 'ymax of bounds is the string "5"'],
];
export const tolerance = (call) => [
  ["not-finite", (d) => call(d, { tolerance: NaN }), "tolerance is NaN"],
  ["not-finite", (d) => call(d, { tolerance: null }), "tolerance is null"],
  ["out-of-range", (d) => call(d, { tolerance: 0 }), "tolerance is 0"],
];
export const digits = (call) => [
  ["out-of-range", (d) => call(d, { digits: 16 }), "digits is 16"],
  ["out-of-range", (d) => call(d, { digits: "2" }), "digits is 2"],
];
export const unknownOption = (call) => [
  ["bad-option", (d) => call(d, { tolerence: 1 }), "options.tolerence is unknown, expected {"],
  ["bad-option", (d) => call(d, 0.5), "options is 0.5, expected {"],
];
/** A thin window, for calls that search windows: it goes to and fro along a line. */
export const scribble = (() => {
  let state = 3;
  const next = () => {
    state = (state * 1103515245 + 12345) % 2 ** 31;
    return state / 2 ** 31;
  };
  return Array.from({ length: 12 }, () => {
    const x = next();
    return [x, 0.7 * x + 3e-14 * next()];
  });
})();
export const searchedBy = (call) => [
  [
    "no-convergence",
    () => call(new Diagram([0, 0, 0]).voronoi(scribble)),
    "sides of the window or cell nearly coincide",
  ],
];
export const aspects = (call) => [
  ...number("options.aspect", (d, aspect) => call(d, { aspect })),
  ["out-of-range", (d) => call(d, { aspect: 0 }), "options.aspect is 0, expected a number from"],
  ["out-of-range", (d) => call(d, { aspect: 1001 }), "options.aspect is 1001, expected"],
  ...unknownOption(call),
];
/** For calls that give polygons. */
export const polygons = (call) => [
  ...tolerance(call),
  ...unknownOption(call),
  ["bad-option", (d) => call(d, { flat: 1 }), "options.flat is 1, expected false or true"],
  ["bad-option", (d) => call(d, { nested: true }), "options.nested is unknown, expected { tol"],
];
/** For calls that look for weights. */
export const fitting = (call) => [
  ["bad-length", (d) => call(d, { targets: [1] }), "targets has 1 elements, expected "],
  ["bad-length", (d) => call(d, { targets: null }), "targets is null, expected an array of num"],
  ["bad-length", (d) => call(d, { start: [1] }), "start has 1 elements, expected "],
  ["bad-length", (d) => call(d, { start: 7 }), "start is 7"],
  ["unknown-site", (d) => call(d, { targets: new Map([[NONE, 1]]) }), "site 1000 does not exist"],
  ["bad-target", (d) => call(d, { targets: equal(d).fill(0) }), "] is 0, expected"],
  ["bad-target", (d) => call(d, { targets: {} }), "targets has none for site"],
  ["not-finite", (d) => call(d, { targets: { 0: "1" } }), 'targets[0] is the string "1"'],
  ["not-finite", (d) => call(d, { start: equal(d).fill(NaN) }), "start[0] is NaN"],
  ["out-of-range", (d) => call(d, { start: equal(d).fill(1e200) }), "start[0] is 1e+200"],
  ["bad-option", (d) => call(d, { onIteration: 7 }), "onIteration is 7"],
  ["bad-option", (d) => call(d, { strict: 1 }), "options.strict is 1, expected false or true"],
  ["bad-option", (d) => call(d, { signals: 1 }), "options.signals is unknown, expected {"],
  ["no-convergence", (d) => call(d, { maxIterations: 1 }), "after 1 steps areas are off by"],
  ["busy", (d) => call(d, { onIteration: () => d.removeMany([]) }), "changed meanwhile"],
  ...tolerance(call),
];
export const interpolateBy =
  (name) =>
  (d, xy = [1, 2], { values = equal(d), ...options } = {}) =>
    d.voronoi([-1e4, -1e4, 1e4, 1e4])[name](values, xy, options);
export const interpolating = (call) => [
  ...numbers("xy", 2, call),
  ["bad-length", (d) => call(d, [1, 2], { values: [1] }), "values has 1 elements, expected "],
  ["bad-length", (d) => call(d, [1, 2], { values: {} }), "values has none for site"],
  [
    "unknown-site",
    (d) => call(d, [1, 2], { values: new Map([[NONE, 1]]) }),
    "site 1000 does not exist",
  ],
  ["not-finite", (d) => call(d, [1, 2], { values: { 0: "1" } }), 'values[0] is the string "1"'],
  ...number("options.r", (d, r) => call(d, [1, 2], { r })),
  ["bad-option", (d) => call(d, [1, 2], { radius: 1 }), "options.radius is unknown, expected {"],
];
/** For calls that draw: with options, and with a context. */
export const drawing = (call, into) => [...tolerance(call), ...flat(call, into)];
export const flat = (call, into) => [
  ...digits(call),
  ...unknownOption(call),
  [
    "bad-option",
    (d) => into(d, { digits: 2 }),
    "context is an object without moveTo(): options go behind it, as in render(null, {",
  ],
  ["bad-option", (d) => into(d, "canvas"), 'context is the string "canvas" without moveTo()'],
];

export const works = (use) => ({ use, refuses: [] });
export const edgesBy = (use) => ({
  use,
  refuses: [
    ...unknownOption(use),
    ["bad-option", (d) => use(d, { clearance: 1 }), "options.clearance is 1, expected false or"],
  ],
});
export const ofSite = (name) => {
  const use = (d, site = 0) => d[name](site);
  return { use, refuses: id(use) };
};
export const drawn = (name) => {
  const use = (d, options) => d[name](null, options);
  return { use, refuses: drawing(use, (d, context) => d[name](context)) };
};
export const ofCell = (name, ...arguments_) => {
  const use = inWindow((v, site = 0) => v[name](site, ...arguments_));
  return { use, refuses: id(use) };
};
