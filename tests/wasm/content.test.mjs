// Tools that know nothing of diagrams: comparisons, JSON, clones, consoles.
import assert from "node:assert";
import { inspect } from "node:util";
import { serialize } from "node:v8";
import { ApolloniusError, Diagram } from "../../build/packed/consumer.mjs";
import { SphericalDiagram } from "../../build/packed/sphere.mjs";
import { randomCircles } from "./support/random.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const xyr = [0, 0, 5, 1, 1, 1, 20, 0, 2];
const rows = [
  { id: 0, x: 0, y: 0, r: 5, hidden: false },
  { id: 1, x: 1, y: 1, r: 1, hidden: true },
  { id: 2, x: 20, y: 0, r: 2, hidden: false },
];

describe("equality", () => {
  const same = () => [
    new Diagram(xyr),
    new Diagram([9, 9, 9, 1, 1, 1, 20, 0, 2]).update(0, 0, 0, 5),
  ];
  const different = [
    ["another radius", (d) => d.update(2, 20, 0, 3)],
    ["a site less", (d) => d.remove(2)],
    ["a site more", (d) => d.insert(7, 7, 1)],
    ["another id", (d) => d.remove(0) && d.insert(20, 0, 2) && d.remove(2) && d.insert(0, 0, 5)],
    ["empty", (d) => d.clear()],
    ["disposed", (d) => d.dispose()],
  ];

  test("the same ids and circles are equal, after any history", () => {
    const [a, b] = same();
    expect(a).toEqual(b);
    expect(a).toStrictEqual(b);
    expect({ deep: [a] }).toStrictEqual({ deep: [b] });
    expect(a.voronoi()).toEqual(b.voronoi());
    assert.deepStrictEqual(a, b);
    assert.deepEqual(a, b);
  });

  test.each(different)("not equal: %s", (what, change) => {
    const [a, b] = same();
    change(b);
    assert.notDeepStrictEqual(a, b);
    assert.notDeepEqual(a, b);
    if (what === "disposed") return; // Jest iterates over both
    expect(a).not.toEqual(b);
    expect(a).not.toStrictEqual(b);
    expect(a.voronoi()).not.toEqual(b.voronoi());
  });

  test("of the same diagram, other bounds are other views", () => {
    const [a] = same();
    expect(a.voronoi([0, 0, 1, 1])).not.toEqual(a.voronoi([0, 0, 1, 2]));
  });
});

test("sites, one by one and as arrays", () => {
  const diagram = new Diagram(xyr);
  expect([...diagram]).toEqual(rows);
  expect(diagram.sites()).toEqual({
    ids: Uint32Array.of(0, 1, 2),
    xyr: Float64Array.from(xyr),
    hidden: Uint8Array.of(0, 1, 0),
  });
  diagram.remove(1);
  expect([...diagram.sites().ids]).toEqual([0, 2]);
  expect([...new Diagram().sites().xyr]).toEqual([]);
});

test("all sites can be moved by what sites() gives", () => {
  const diagram = new Diagram(randomCircles(50, 51));
  diagram.remove(7);
  const { ids, xyr: circles } = diagram.sites();
  diagram.updateMany(
    ids,
    circles.map((value) => value + 1),
  );
  expect(diagram.sites().xyr).toEqual(circles.map((value) => value + 1));
});

test("a loop sees the sites as they were when it began", () => {
  const diagram = new Diagram(xyr);
  const seen = [];
  for (const { id } of diagram) {
    seen.push(id);
    diagram.clear();
  }
  expect(seen).toEqual([0, 1, 2]);
});

test("JSON has the sites, and from reads them", () => {
  const diagram = new Diagram(xyr);
  const read = JSON.parse(JSON.stringify({ diagram })).diagram;
  expect(read).toEqual(rows);
  expect(Diagram.from(read)).toEqual(diagram);
  expect(Diagram.from(diagram)).toEqual(diagram);
});

test.each([
  ["structuredClone", structuredClone],
  ["v8.serialize", serialize],
  ["postMessage", (message) => new MessageChannel().port1.postMessage(message)],
])("%s refuses a diagram and says what to do", (_, copy) => {
  const diagram = new Diagram(xyr);
  const disposed = new Diagram();
  disposed.dispose();
  for (const message of [diagram, { diagram }, diagram.voronoi(), disposed])
    expect(() => copy(message)).toThrow(/toBytes\(\) and fromBytes\(\).* could not be cloned/);
});

test("consoles show a few words", () => {
  const diagram = new Diagram(xyr);
  expect(inspect(diagram)).toBe("Diagram { size: 3, hidden: 1 }");
  expect(`${diagram}`).toBe("Diagram { size: 3, hidden: 1 }");
  const view = diagram.voronoi([0, 0, 4, 5]);
  expect(inspect(view)).toBe("Voronoi { window: [0, 0, 4, 5], cells: 2 }");
  expect(inspect(view.window)).toMatch(/^VoronoiWindow \{\s+bounds: \[ 0, 0, 4, 5 \],\s+area: 20,/);
  const globe = new SphericalDiagram([0, 0, 0, 90, 0, 0]);
  expect(inspect(globe.voronoi())).toBe("SphericalVoronoi { cells: 2 }");
  expect(
    [diagram, diagram.voronoi()].map((object) => Object.prototype.toString.call(object)),
  ).toEqual(["[object Diagram]", "[object Voronoi]"]);
  diagram.dispose();
  expect([inspect(diagram), String(diagram)]).toEqual(Array(2).fill("Diagram { disposed }"));
  expect(inspect(view)).toBe("Voronoi { disposed }");
});

test("names are as documented, though the package is minified", () => {
  expect(
    [Diagram, new Diagram().voronoi().constructor, ApolloniusError].map(({ name }) => name),
  ).toEqual(["Diagram", "Voronoi", "ApolloniusError"]);
  const error = new ApolloniusError("broken", "why");
  expect([error.name, error.stack.split("\n")[0], inspect(error).split("\n")[0]]).toEqual([
    "ApolloniusError",
    "ApolloniusError: why",
    "ApolloniusError: why",
  ]);
  expect(Object.keys(error)).toEqual(["code"]);
});

test("a Voronoi is made by a diagram only", () => {
  const Voronoi = new Diagram().voronoi().constructor;
  for (const diagram of [undefined, null, {}, 7])
    expectRefusal(
      () => new Voronoi(diagram, [0, 0, 1, 1]),
      "bad-option",
      "diagram.voronoi(bounds)",
    );
});
