// Diagram.from: items of all kinds, accessors as in d3.
import { ApolloniusError, Diagram } from "../../build/packed/consumer.mjs";
import { SphericalDiagram } from "../../build/packed/sphere.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const expected = [
  { x: 1, y: 2, r: 3 },
  { x: 40, y: 5, r: 0 },
];

function sites(diagram) {
  return [...diagram.ids()].map((id) => diagram.site(id));
}

test("objects, with r or without", () => {
  expect(
    sites(
      Diagram.from([
        { x: 1, y: 2, r: 3 },
        { x: 40, y: 5 },
      ]),
    ),
  ).toEqual(expected);
});

test("arrays and typed arrays, with r or without", () => {
  expect(
    sites(
      Diagram.from([
        [1, 2, 3],
        [40, 5],
      ]),
    ),
  ).toEqual(expected);
  expect(sites(Diagram.from([new Float32Array([1, 2, 3]), new Float64Array([40, 5])]))).toEqual(
    expected,
  );
});

test("any iterable: a set, a generator", () => {
  function* items() {
    yield [1, 2, 3];
    yield { x: 40, y: 5 };
  }
  expect(sites(Diagram.from(items()))).toEqual(expected);
  expect(
    sites(
      Diagram.from(
        new Set([
          [1, 2, 3],
          [40, 5],
        ]),
      ),
    ),
  ).toEqual(expected);
});

test("array-likes", () => {
  expect(sites(Diagram.from({ length: 2, 0: [1, 2, 3], 1: [40, 5] }))).toEqual(expected);
});

test("accessors get item, index and all items", () => {
  const items = [
    { lon: 1, lat: 2, size: 9 },
    { lon: 40, lat: 5, size: 0 },
  ];
  const calls = [];
  const diagram = Diagram.from(
    items,
    (d) => d.lon,
    (d, i, all) => {
      calls.push([i, all === items]);
      return d.lat;
    },
    (d) => Math.sqrt(d.size),
  );
  expect(sites(diagram)).toEqual(expected);
  expect(calls).toEqual([
    [0, true],
    [1, true],
  ]);
});

test("two accessors read points, as d3-delaunay has it, whatever else the items have", () => {
  const x = (d) => d.x ?? d[0];
  const y = (d) => d.y ?? d[1];
  const items = [
    { x: 1, y: 2, r: 3, radius: 3, size: 3, weight: 3 },
    { x: 40, y: 5, r: null, size: "large" },
    [7, 8, 9],
    new Float64Array([3, 4, NaN]),
  ];
  const points = [
    { x: 1, y: 2, r: 0 },
    { x: 40, y: 5, r: 0 },
    { x: 7, y: 8, r: 0 },
    { x: 3, y: 4, r: 0 },
  ];
  expect(sites(Diagram.from(items, x, y))).toEqual(points);
  expect(sites(Diagram.from(items, x, y, undefined))).toEqual(points);
  expect(sites(Diagram.from(items, x, y, null, {}))).toEqual(points);
  const radii = sites(Diagram.from(items, x, y, (_, k) => k));
  expect(radii.map(({ r }) => r)).toEqual([0, 1, 2, 3]);
  // With one of them they are circles, as without.
  const circles = [{ x: 1, y: 2, r: 3 }];
  expect(sites(Diagram.from(circles, x))).toEqual(circles);
  expect(sites(Diagram.from(circles, undefined, y))).toEqual(circles);
  expect(sites(Diagram.from(circles, undefined, undefined, (d) => 2 * d.r))[0].r).toBe(6);
});

test.each(["radius", "size", "weight"])("an item with a %s and no r is refused", (name) => {
  const item = { x: 1, y: 2, [name]: 5 };
  const refused = expect.objectContaining({
    code: "bad-option",
    message:
      `item 1 has a ${name} and no r: give (d) => d.${name} as third accessor, or the option ` +
      "{ r: 0 } for points",
  });
  for (const one of [
    item,
    { ...item, r: undefined },
    { x: 1, y: 2, [name]: undefined },
    Object.create(item), // as if its class had the property
  ]) {
    expect(() => Diagram.from([[0, 0], one])).toThrow(refused);
    expect(() => Diagram.from([[0, 0], one], (d) => d.x ?? d[0])).toThrow(refused);
  }
  expect(sites(Diagram.from([{ ...item, r: 4 }]))).toEqual([{ x: 1, y: 2, r: 4 }]);
  const [site] = sites(Diagram.from([item], undefined, undefined, (d) => d[name]));
  expect(site).toEqual({ x: 1, y: 2, r: 5 });
});

test("no items", () => {
  expect(Diagram.from([]).size).toBe(0);
});

test.each([
  [[{ x: 1, y: 2 }, { x: 1 }], "y of item 1 is undefined"],
  [[[1, 2, NaN]], "r of item 0 is NaN"],
  [[[1, 2, null]], "r of item 0 is null"],
  [[{ x: 1, y: 2, r: null }], "r of item 0 is null"],
  [[{ x: 1, y: 2, r: null, radius: 5 }], "r of item 0 is null"],
  [[["1", 2]], 'x of item 0 is the string "1"'],
  [[null], "item 0 is null, expected {x, y, r} or [x, y, r]"],
  [[{ x: 1, y: Infinity }], "y of item 0 is Infinity"],
])("%j is refused", (items, message) => {
  expect(() => Diagram.from(items)).toThrow(ApolloniusError);
  expect(() => Diagram.from(items)).toThrow(
    expect.objectContaining({ code: "not-finite", message: expect.stringContaining(message) }),
  );
});

test("what looks like a place, and what is not awaited, is refused with the remedy", () => {
  for (const [lon, lat] of [
    ["lng", "lat"],
    ["lon", "lat"],
    ["longitude", "latitude"],
  ]) {
    const items = [{ [lon]: 2, [lat]: 48 }];
    const remedy = `: SphericalDiagram.from(items, (d) => d.${lon}, (d) => d.${lat}) reads places`;
    expectRefusal(() => Diagram.from(items), "not-finite", remedy);
    const globe = SphericalDiagram.from(
      items,
      (d) => d[lon],
      (d) => d[lat],
    );
    expect(globe.site(0)).toEqual({ lon: 2, lat: 48, r: 0 });
    if (lon === "lon") continue;
    expectRefusal(() => SphericalDiagram.from(items), "not-finite", remedy);
  }
  const said = expectRefusal(() => Diagram.from([{}]), "not-finite", "x of item 0 is undefined");
  expect(said.message).not.toContain("Spherical");
  for (const call of [
    (promise) => Diagram.from(promise),
    (promise) => new Diagram(promise),
    (promise) => SphericalDiagram.from(promise),
    (promise) => Diagram.fromBytes(promise),
  ])
    expectRefusal(() => call(Promise.resolve([])), "bad-length", "is a promise, not awaited");
});

test("an item out of range is named", () => {
  expect(() =>
    Diagram.from([
      [0, 0],
      [1e200, 0],
    ]),
  ).toThrow(
    expect.objectContaining({
      code: "out-of-range",
      message: expect.stringContaining("x of item 1 is 1e+200"),
    }),
  );
});
