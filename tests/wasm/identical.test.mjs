// Identical circles: the one with the least id has the cell, on both surfaces, after any history.
// find, pick, neighbours, cells and restored diagrams name the same one.
import { Diagram } from "../../build/packed/consumer.mjs";
import { validate } from "../../build/packed/diagnostics.mjs";
import { SphericalDiagram } from "../../build/packed/sphere.mjs";
import { generator } from "./support/random.mjs";

const random = generator(67);
const whole = (below) => Math.floor(random() * below);

/** Name, class, and cells as GeoJSON. On both surfaces a site is named by two numbers. */
const surfaces = [
  ["plane", Diagram, (diagram) => diagram.voronoi([-1, -1, 50, 50]).toGeoJSON()],
  ["sphere", SphericalDiagram, (diagram) => diagram.voronoi().toGeoJSON()],
];

describe.each(surfaces)("%s", (_, Class, cellsOf) => {
  function expectLeast(diagram, places) {
    const firstOf = (id) => {
      const [x, y] = places.get(id);
      return [...places.keys()]
        .sort((a, b) => a - b)
        .find((other) => places.get(other)[0] === x && places.get(other)[1] === y);
    };
    for (const [id, [x, y]] of places) {
      const first = firstOf(id);
      expect(diagram.isHidden(id)).toBe(id !== first);
      expect([diagram.find(x, y), diagram.pick(x, y)]).toEqual([first, first]);
      expect(diagram.kNearest(x, y, 1)[0]).toBe(first);
      expect(diagram.pick(x, y, { filter: () => true })).toBe(first);
    }
    const visible = [...places.keys()].filter((id) => firstOf(id) === id).sort((a, b) => a - b);
    expect(cellsOf(diagram).features.map(({ id }) => id)).toEqual(visible);
    for (const id of visible)
      for (const neighbor of diagram.neighbors(id)) expect(visible).toContain(neighbor);
    expect(validate(diagram)).toBe(null);
  }

  test("built, inserted, moved, removed, restored", () => {
    for (let round = 0; round < 30; ++round) {
      const spots = Array.from({ length: 5 }, () => [whole(9), whole(9)]);
      const spot = () => spots[whole(5)];
      const rows = Array.from({ length: 20 }, spot);
      const diagram = Class.from(rows);
      const places = new Map(rows.entries());
      expectLeast(diagram, places);
      for (const id of [3, 7, 11]) {
        diagram.update(id, 40, 40, 0);
        places.set(id, [40, 40]);
      }
      expectLeast(diagram, places);
      for (const id of [7, 3, 11]) {
        diagram.update(id, ...rows[id], 0);
        places.set(id, rows[id]);
      }
      expectLeast(diagram, places);
      for (let k = 0; k < 6; ++k) {
        const id = [...places.keys()][whole(places.size)];
        diagram.remove(id);
        places.delete(id);
      }
      expectLeast(diagram, places);
      const some = Array.from({ length: 8 }, spot);
      const ids = diagram.insertMany(some.flatMap(([x, y]) => [x, y, 0]));
      ids.forEach((id, k) => places.set(id, some[k]));
      expectLeast(diagram, places);
      const moved = [...places.keys()];
      const there = moved.map(spot);
      diagram.updateMany(
        moved,
        there.flatMap(([x, y]) => [x, y, 0]),
      );
      moved.forEach((id, k) => places.set(id, there[k]));
      expectLeast(diagram, places);
      const restored = Class.fromBytes(diagram.toBytes());
      expectLeast(restored, places);
    }
  });

  test("an unrelated insertion changes nothing", () => {
    const diagram = Class.from([...Array(6).fill([10, 10]), [30, 20]]);
    for (let k = 0; k < 100; ++k) diagram.insert(whole(49), whole(49), 0);
    expect(diagram.find(10, 10)).toBe(0);
    diagram.remove(0);
    expect(diagram.find(10, 10)).toBe(1);
    expect(diagram.insert(10, 10, 0)).toBe(0);
    expect(diagram.find(10, 10)).toBe(0);
  });
});

test("poles and the antimeridian have many names, and identical sites one cell", () => {
  for (const places of [
    [0, 90, 0, 50, 90, 0, -120, 90, 0],
    [33, -90, 0, 0, -90, 0],
    [180, 10, 1, -180, 10, 1, 540, 10, 1],
  ]) {
    const globe = new SphericalDiagram([...places, 12, 3, 0]);
    expect(globe.visibleSize).toBe(2);
    expect(globe.isHidden(0)).toBe(false);
    for (let k = 0; k < 40; ++k) globe.insert(whole(360), whole(60) - 30, 0);
    expect(globe.isHidden(0)).toBe(false);
  }
});
