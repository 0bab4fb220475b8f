// The option `r` on both surfaces: numbers are pairs; all sites have one radius, or keep theirs.
import { Diagram } from "../../build/packed/consumer.mjs";
import { SphericalDiagram } from "../../build/packed/sphere.mjs";
import { generator } from "./support/random.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const surfaces = [
  ["Diagram", Diagram, "xy", { r: 1e101 }],
  ["SphericalDiagram", SphericalDiagram, "lonLat", { r: 4 }],
];

describe.each(surfaces)("%s", (_, Surface, points, tooLarge) => {
  const random = generator(5);
  const places = Array.from({ length: 40 }, () => [180 * random() - 90, 180 * random() - 90]);
  const pairs = places.flat();
  const triples = (r) => places.flatMap(([x, y], k) => [x, y, typeof r === "number" ? r : r[k]]);

  test.each([0, -0.5, 0.25])("r = %p: as triples with that radius", (r) => {
    const expected = new Surface(triples(r));
    for (const numbers of [pairs, Float64Array.from(pairs)]) {
      expect(new Surface(numbers, { r })).toEqual(expected);
      expect(Surface.from(numbers, { r })).toEqual(expected);
      const filled = new Surface();
      expect(filled.insertMany(numbers, { r }).length).toBe(40);
      expect(filled).toEqual(expected);
    }
    expect(Surface.from(places, { r })).toEqual(expected);
    expect(
      Surface.from(
        places.map(([x, y]) => [x, y, 1]),
        { r },
      ),
    ).toEqual(expected);
    expect(
      Surface.from(
        places,
        (d) => d[0],
        (d) => d[1],
        { r },
      ),
    ).toEqual(expected);
  });

  test("updateMany keeps radii, or gives all the same", () => {
    const radii = places.map(() => random() / 4);
    const diagram = new Surface(places.flatMap((_, k) => [k, 0, radii[k]]));
    const ids = diagram.ids();
    diagram.updateMany(ids, pairs, { r: "keep" });
    expect(diagram).toEqual(new Surface(triples(radii)));
    diagram.updateMany([3, 5], [1, 2, 3, 4], { r: "keep" });
    expect(Object.values(diagram.site(5))).toEqual([3, 4, radii[5]]);
    diagram.updateMany(ids, pairs, { r: 0.125 });
    expect(diagram).toEqual(new Surface(triples(0.125)));
    diagram.updateMany([], [], { r: "keep" });
  });

  test("what is wrong is named, and changes nothing", () => {
    const diagram = new Surface(triples(0.1));
    const before = diagram.toBytes();
    const refusals = [
      [() => diagram.insertMany([1, 2, 3], { r: 0 }), "bad-length", `2 values in ${points}, got 3`],
      [() => diagram.insertMany([1, NaN], { r: 0 }), "not-finite", `${points}[1] is NaN`],
      [() => diagram.insertMany([1, 2], tooLarge), "out-of-range", `options.r is ${tooLarge.r}`],
      [() => diagram.insertMany([1, 2], { r: "keep" }), "not-finite", "options.r is the string"],
      [() => diagram.insertMany([1, 2], { radius: 1 }), "bad-option", "expected { r }"],
      [() => diagram.updateMany([0], [1, 2, 3], { r: 0 }), "bad-length", `2 values in ${points}`],
      [() => diagram.updateMany([0], [1, 2]), "bad-length", "a multiple of 3 values"],
      [() => diagram.updateMany([0, 1], [1, 2], { r: "keep" }), "bad-length", "expected 4 values"],
      [
        () => diagram.updateMany([0, 99], pairs.slice(0, 4), { r: "keep" }),
        "unknown-site",
        "ids[1]",
      ],
      [() => diagram.updateMany([0], [1, NaN], { r: "keep" }), "not-finite", `${points}[1] is NaN`],
      [
        () => diagram.updateMany([0], [1, 2], tooLarge),
        "out-of-range",
        `options.r is ${tooLarge.r}`,
      ],
    ];
    for (const [call, code, message] of refusals) expectRefusal(call, code, message);
    expect(diagram.toBytes()).toEqual(before);
  });
});
