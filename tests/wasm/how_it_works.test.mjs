// levels() and predicateCounts(): what can be seen of how the diagram works.
import { Diagram } from "../../build/packed/consumer.mjs";
import { levels, predicateCounts } from "../../build/packed/diagnostics.mjs";
import { randomCircles } from "./support/random.mjs";

describe("levels", () => {
  test("by id: 0 for hidden sites and free ids, more than 1 for one in 32", () => {
    const diagram = new Diagram(randomCircles(5000, 71));
    diagram.insert(1e4, 0, 50);
    const hidden = diagram.insert(1e4, 0, 5);
    diagram.remove(17);
    const counts = levels(diagram);
    expect(counts).toBeInstanceOf(Uint8Array);
    expect([counts.length, counts[hidden], counts[17]]).toEqual([5002, 0, 0]);
    expect(counts.filter((count) => count > 0)).toHaveLength(diagram.visibleSize);
    const share = counts.filter((count) => count > 1).length / diagram.visibleSize;
    expect(share * 32).toBeGreaterThan(0.7);
    expect(share * 32).toBeLessThan(1.3);
    counts.fill(7); // the caller's own
    expect(levels(diagram)[17]).toBe(0);
  });

  test("a snapshot keeps them", () => {
    const diagram = new Diagram(randomCircles(2000, 72));
    const bytes = diagram.toBytes();
    expect(levels(Diagram.fromBytes(bytes))).toEqual(levels(diagram));
    expect([...levels(new Diagram())]).toEqual([]);
  });
});

describe("predicateCounts", () => {
  const stages = {
    filter: expect.any(Number),
    middle: expect.any(Number),
    exact: expect.any(Number),
  };

  test("has what the types say, and is a record of its own each time", () => {
    const counts = predicateCounts();
    const [covers, distance, bearing, vertexConflict, edgeConflict] = new Array(5).fill(stages);
    const ties = expect.any(Number);
    expect(counts).toEqual({ covers, distance, bearing, vertexConflict, edgeConflict, ties });
    counts.covers.filter = -1;
    expect(predicateCounts().covers.filter).toBeGreaterThanOrEqual(0);
  });

  test("differences are what calls have asked: doubles settle random circles, not grids", () => {
    const askedBy = (xyr) => {
      const before = predicateCounts();
      new Diagram(xyr).dispose();
      const after = predicateCounts();
      const since = (name, stage) => after[name][stage] - before[name][stage];
      return {
        edges: since("edgeConflict", "filter"),
        middle: since("vertexConflict", "middle"),
        exact: since("vertexConflict", "exact"),
        ties: after.ties - before.ties,
      };
    };
    expect(askedBy([])).toEqual({ edges: 0, middle: 0, exact: 0, ties: 0 });
    const random = askedBy(randomCircles(1000, 73));
    expect(random).toMatchObject({ middle: 0, exact: 0, ties: 0 });
    expect(random.edges).toBeGreaterThan(1000);
    const grid = askedBy(
      Array.from({ length: 300 }, (_, k) => [k % 10, Math.floor(k / 10), 0]).flat(),
    );
    expect(grid.exact).toBe(0);
    expect(grid.middle).toBeGreaterThan(0);
    expect(grid.ties).toBeGreaterThan(80);
  });
});
