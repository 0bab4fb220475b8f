// Refusals of SphericalDiagram's calls, with code and words; none changes the diagram.
import { createRequire } from "node:module";
import { ApolloniusError, Diagram } from "../../build/packed/consumer.mjs";
import { validate } from "../../build/packed/diagnostics.mjs";
import { SphericalDiagram, ApolloniusError as TheirError } from "../../build/packed/sphere.mjs";
import { prototypesOf } from "./support/methods.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const earth = { radius: 6371 };
const make = () => new SphericalDiagram([0, 0, 100, 90, 10, 0, 1, 0, 0], earth);

test("both entries have one class of errors", () => {
  expect(TheirError).toBe(ApolloniusError);
});

test("as CommonJS they share the module, too, which gets its second part once", () => {
  const require = createRequire(new URL("../../build/packed/sphere.mjs", import.meta.url));
  const entry = require("apollonius-diagram/sphere");
  expect(entry.ApolloniusError).toBe(require("apollonius-diagram").ApolloniusError);
  const diagrams = [0, 1].map((lon) => new entry.SphericalDiagram([lon, 0, 0]));
  expect(diagrams.map((diagram) => diagram.nearest(3, 0).distance * (180 / Math.PI))).toEqual([
    expect.closeTo(3),
    expect.closeTo(2),
  ]);
});

const hint = "expected a latitude from -90 to 90: longitude comes first, then latitude";
const calls = [
  ["find", (d, lon, lat) => d.find(lon, lat)],
  ["nearest", (d, lon, lat) => d.nearest(lon, lat)],
  ["farthest", (d, lon, lat) => d.farthest(lon, lat)],
  ["pick", (d, lon, lat) => d.pick(lon, lat)],
  ["kNearest", (d, lon, lat) => d.kNearest(lon, lat, 2)],
  ["within", (d, lon, lat) => d.within(lon, lat, 5)],
  ["contains", (d, lon, lat) => d.voronoi().contains(0, lon, lat)],
  ["naturalWeights", (d, lon, lat) => d.voronoi().naturalWeights(lon, lat)],
  ["insert", (d, lon, lat) => d.insert(lon, lat, 0)],
  ["update", (d, lon, lat) => d.update(0, lon, lat)],
];
test.each(calls)("%s refuses what is no point", (_, call) => {
  const diagram = make();
  const before = diagram.sites();
  expectRefusal(() => call(diagram, NaN, 0), "not-finite", "lon is NaN");
  expectRefusal(() => call(diagram, "2", 0), "not-finite", 'lon is the string "2"');
  expectRefusal(() => call(diagram, 0, undefined), "not-finite", "lat is undefined");
  expectRefusal(() => call(diagram, 2, 90.5), "out-of-range", `lat is 90.5, ${hint}`);
  expect(diagram.sites()).toEqual(before);
});

const ofCells = ["cellArea", "cellCentroid", "cellPerimeter", "cellMeasures", "cellPolygon"];
ofCells.push("cellGeometry", "contains", "neighbors");

test("arrays, weights, options and ids are refused by name", () => {
  const diagram = make();
  const before = diagram.sites();
  const { find } = diagram;
  const view = diagram.voronoi();
  const { cellArea } = view;
  const within = (maxDistance) => diagram.voronoi({ maxDistance });
  for (const [call, code, message] of [
    [() => diagram.insertMany([1, 2]), "bad-length", "a multiple of 3 values in lonLatR, got 2"],
    [() => diagram.insertMany([1, 2, 3, 4, 95, 6]), "out-of-range", `lonLatR[4] is 95, ${hint}`],
    [() => diagram.insertMany([1, 2, 2e4 + 16]), "out-of-range", "lonLatR[2] is 20016"],
    [() => diagram.insertMany([[1, 2, 3]]), "not-finite", "lonLatR is flat"],
    [() => diagram.insert(0, 0, 30000), "out-of-range", "r is 30000, expected less than half a gr"],
    [() => diagram.updateMany([0, 1], [1, 2, 3]), "bad-length", "expected 6 values in lonLatR"],
    [() => diagram.updateMany([0, 9], [1, 2, 3, 4, 5, 6]), "unknown-site", "ids[1]: site 9 does"],
    [() => diagram.update(9, 0, 0), "unknown-site", "site 9 does not exist"],
    [() => diagram.site("0"), "unknown-site", "ids are whole numbers"],
    [() => diagram.remove(0.5), "unknown-site", "ids are whole numbers"],
    [() => diagram.findMany([1, 2, 3]), "bad-length", "a multiple of 2 values in lonLat, got 3"],
    [() => diagram.findMany([1, 200]), "out-of-range", "lonLat[1] is 200"],
    [() => diagram.kNearestMany([1, 200], 1), "out-of-range", "lonLat[1] is 200"],
    [() => diagram.withinMany([1, 2, 3], 1), "bad-length", "a multiple of 2 values in lonLat"],
    [() => diagram.pick(0, 0, { maxDistance: -1 }), "out-of-range", "maxDistance is -1"],
    [() => diagram.pickMany([1, 200]), "out-of-range", "lonLat[1] is 200"],
    [() => diagram.kNearest(0, 0, -1), "out-of-range", "k is -1"],
    [() => diagram.kNearest(0, 0, 1, { filter: 3 }), "bad-option", "options.filter is 3"],
    [() => diagram.kNearest(0, 0, 1, { far: 3 }), "bad-option", "options.far is unknown"],
    [() => diagram.within(0, 0, NaN), "not-finite", "maxDistance is NaN"],
    [() => diagram.voronoi({ maxDistance: NaN }), "not-finite", "options.maxDistance is NaN"],
    [() => diagram.voronoi({ maxDistance: "1" }), "not-finite", "maxDistance is the string"],
    [() => diagram.voronoi({ maxDistance: 1e101 }), "out-of-range", "maxDistance is 1e+101"],
    [() => diagram.voronoi({ maxDistance: -Infinity }), "not-finite", "maxDistance is -Inf"],
    [() => diagram.voronoi({ distance: 1 }), "bad-option", "options.distance is unknown"],
    [() => diagram.voronoi([0, 0, 1, 1]), "bad-option", "options is an array of 4, expected { max"],
    [() => within([1]).cellAreas(), "bad-option", "an array of 1 that has none for site 1"],
    [() => within([NaN, 1, 1]).cellArea(0), "not-finite", "maxDistance of site 0 is NaN"],
    [() => within([1, 1, NaN]).cellPerimeters(), "not-finite", "maxDistance of site 2 is NaN"],
    [() => within(new Map()).cellCentroids(), "bad-option", "an object that has none for site 0"],
    [() => within({}).toGeoJSON(), "bad-option", "add it there, or give a function of an id"],
    [() => [...within([0]).cellPolygons()], "bad-option", "has none for site 1"],
    [() => within(() => diagram.clear()).cellAreas(), "busy", "nor may maxDistance"],
    [() => within(() => diagram.insert(0, 0)).contains(0, 0, 0), "busy", "nor may maxDistance"],
    [() => view.cellPolygon(0, { tolerance: 0 }), "out-of-range", "options.tolerance is 0, expec"],
    [
      () => view.cellMesh({ tolerance: 6e-6 }),
      "out-of-range",
      "expected at least 1e-9 of the radius, which is 6371",
    ],
    [() => view.cellMesh({ winding: "clockwise" }), "bad-option", "options.winding is unknown"],
    [
      () => view.cellPolygon(0, { antimeridian: "cut" }),
      "bad-option",
      "options.antimeridian is un",
    ],
    [() => view.naturalWeights(0, 0, { r: 3e4 }), "out-of-range", "options.r is 30000"],
    [() => view.naturalWeights(0, 0, 1), "bad-option", "options is 1, expected { r }"],
    [() => view.interpolate([1, 2], [0, 0]), "bad-length", "values has 2 elements"],
    [() => view.interpolate([1, 2, 3], [0]), "bad-length", "a multiple of 2 values in lonLat"],
    [() => view.interpolate([1, 2, 3], [0, 91]), "out-of-range", `lonLat[1] is 91, ${hint}`],
    [() => view.interpolate([1, 2, 3], [0, 0], { r: NaN }), "not-finite", "options.r is NaN"],
    [() => view.emptyCircles(-1), "out-of-range", "count is -1"],
    [() => view.toGeoJSON({ winding: "left" }), "bad-option", "options.winding"],
    [() => view.toGeoJSON({ antimeridian: true }), "bad-option", "options.antimeridian"],
    [() => view.toGeoJSON({ properties: 5 }), "bad-option", "options.properties is 5"],
    [() => view.cellGeometry(0, { properties: 5 }), "bad-option", "options.properties is unknown"],
    [() => view.cellGeometry(0, { antimeridian: true }), "bad-option", "options.antimeridian"],
    ...ofCells.map((name) => [() => view[name](3), "unknown-site", "site 3 does not exist"]),
    [() => cellArea(0), "bad-option", "a method was called on undefined"],
    [() => cellArea.call(diagram, 0), "bad-option", "a method was called on an object"],
    [() => new SphericalDiagram([], { radius: 0 }), "out-of-range", "options.radius is 0"],
    [() => new SphericalDiagram([], { radius: "1" }), "not-finite", "options.radius is the string"],
    [() => new SphericalDiagram([], { size: 1 }), "bad-option", "options.size is unknown"],
    [
      () => SphericalDiagram.from([{ x: 1, y: 2 }]),
      "not-finite",
      "item 0 is an object, expected {",
    ],
    [() => SphericalDiagram.from([[1, 2], null]), "not-finite", "item 1 is null, expected {lon"],
    [() => SphericalDiagram.from([[48, 200]]), "out-of-range", `lat of item 0 is 200, ${hint}`],
    [
      () => SphericalDiagram.from([{ lon: 1, lat: 2, r: null }]),
      "not-finite",
      "r of item 0 is null",
    ],
    [
      () => SphericalDiagram.from([{ lon: 1, lat: 2, radius: 3 }]),
      "bad-option",
      "item 0 has a radius and no r: give (d) => d.radius as third accessor",
    ],
    [
      () => SphericalDiagram.from([[1, 2]], { radius: 3 }, (d) => d[0]),
      "bad-option",
      "options are not last",
    ],
    [() => SphericalDiagram.from(7), "bad-length", "items is 7"],
    [() => SphericalDiagram.from([], "lon"), "bad-option", 'lon is the string "lon"'],
    [() => SphericalDiagram.fromBytes(new Uint8Array(8)), "corrupt-snapshot", "no snapshot"],
    [() => SphericalDiagram.fromBytes([1]), "bad-length", "bytes is an array of 1"],
    [() => SphericalDiagram.fromBytes(new Diagram().toBytes()), "corrupt-snapshot", "no snapshot"],
    [() => find(0, 0), "bad-option", "a method was called on undefined"],
    [() => Diagram.prototype.hull.call(diagram), "bad-option", "a method was called on an o"],
  ])
    expectRefusal(call, code, message);
  expect(diagram.sites()).toEqual(before);
  expect(validate(diagram)).toBeNull();
});

test("what a filter may not do, and what a disposed diagram says", async () => {
  const diagram = make();
  const view = diagram.voronoi();
  const changing = ["insert", "remove", "update", "insertMany", "removeMany", "updateMany"];
  for (const name of [...changing, "clear", "dispose"])
    diagram.kNearest(0, 0, 1, {
      filter: () => {
        const lists = name.endsWith("Many");
        expectRefusal(() => diagram[name](lists ? [] : 0, lists ? [] : 0, 0), "busy", "a filter");
        return true;
      },
    });
  expect(diagram.size).toBe(3);
  diagram.dispose();
  diagram.dispose();
  const accessors = prototypesOf(SphericalDiagram).flatMap((prototype) =>
    Object.entries(Object.getOwnPropertyDescriptors(prototype)),
  );
  const skipped = ["constructor", "dispose", "toString"];
  for (const [name, { value, get }] of accessors) {
    if (skipped.includes(name)) continue;
    if (get !== undefined) {
      expectRefusal(() => get.call(diagram), "disposed", "has been disposed of");
    } else if (name === "voronoi") {
      expectRefusal(() => diagram.voronoi(), "disposed", "has been disposed of");
    } else {
      const lists = name.endsWith("Many");
      const args = lists ? [[], []] : [0, 0, 0, 0];
      expectRefusal(() => value.apply(diagram, args), "disposed", "has been disposed of");
    }
  }
  for (const [name, { value }] of Object.entries(
    Object.getOwnPropertyDescriptors(Object.getPrototypeOf(view)),
  )) {
    if (name === "constructor" || value === undefined) continue;
    const args = name.startsWith("interpolate")
      ? [[], []]
      : /^cellCircles/.test(name)
        ? []
        : [0, undefined, undefined];
    const ask = () => {
      const answer = value.apply(
        view,
        /^(toGeoJSON|cellMesh|cellPolygons)$/.test(name) ? [] : args,
      );
      return name === "cellPolygons" ? [...answer] : answer;
    };
    if (name.endsWith("Async")) await expect(ask()).rejects.toMatchObject({ code: "disposed" });
    else expectRefusal(ask, "disposed", "has been disposed of");
  }
  expect(String(diagram)).toBe("SphericalDiagram { disposed }");
});

test("equal diagrams are equal to test frameworks, others are not", () => {
  expect(make()).toEqual(make());
  const other = make();
  other.remove(2);
  expect(other).not.toEqual(make());
  expect(() => structuredClone(other)).toThrow("toBytes()");
});
