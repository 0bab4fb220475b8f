// Drawings into contexts and as path strings.
import { Diagram } from "../../build/packed/consumer.mjs";
import { validate } from "../../build/packed/diagnostics.mjs";
import { randomCircles } from "./support/random.mjs";
import { Recorder } from "./support/recorder.mjs";

const diagram = new Diagram(randomCircles(200, 71, 90));
const voronoi = diagram.voronoi([-900, -700, 1000, 800]);

const drawings = {
  render: (context, options) => voronoi.render(context, options),
  renderBounds: (context, options) => voronoi.renderBounds(context, options),
  renderCell: (context, options) => voronoi.renderCell(diagram.find(0, 0), context, options),
  dual: (context, options) => diagram.render(context, options),
  dualWithRays: (context, options) =>
    diagram.render(context, { ...options, bounds: [-900, -700, 1000, 800] }),
  renderSites: (context, options) => diagram.renderSites(context, options),
  renderHull: (context, options) => diagram.renderHull(context, options),
};

const letters = { moveTo: "M", lineTo: "L", bezierCurveTo: "C", closePath: "Z" };

test.each(
  Object.entries(drawings),
)("%s draws the same into a context and as a string", (_, draw) => {
  const recorder = new Recorder();
  expect(draw(recorder)).toBeUndefined();
  expect(recorder.calls.length).toBeGreaterThan(3);
  expect(recorder.calls[0][0]).toBe("moveTo");
  expect(
    recorder.calls.flat().every((value) => typeof value === "string" || Number.isFinite(value)),
  ).toBe(true);
  const text = recorder.calls.map(([name, ...numbers]) => letters[name] + numbers.join()).join("");
  expect(draw()).toBe(text);
  expect(draw(null)).toBe(text);
});

test.each(Object.entries(drawings))("%s rounds to the digits that are asked for", (_, draw) => {
  const text = draw(null, { digits: 1 });
  expect(text).toMatch(/^[MLCZ0-9.,-]+$/);
  expect(text).not.toMatch(/\.\d\d/);
  expect(draw(null, { digits: 0 })).not.toMatch(/\./);
});

test("edges are drawn once, cells and circles are closed", () => {
  const count = (draw, name) => {
    const recorder = new Recorder();
    draw(recorder);
    return recorder.count(name);
  };
  expect(count(drawings.render, "moveTo")).toBe(voronoi.edgeCurves().sites.length / 2);
  expect(count(drawings.render, "closePath")).toBe(0);
  expect(count(drawings.renderSites, "closePath")).toBe(200);
  expect(count(drawings.dual, "moveTo")).toBe(diagram.edges().sites.length / 2);
  expect(count(drawings.dualWithRays, "moveTo")).toBeGreaterThan(count(drawings.dual, "moveTo"));
  expect(count(drawings.renderHull, "closePath")).toBe(1);
  const id = diagram.find(0, 0);
  expect(count((context) => voronoi.renderCell(id, context), "closePath")).toBe(
    voronoi.cellParts(id).length,
  );
});

test("a context may change the diagram while it is drawn into, and nothing breaks", () => {
  const changing = new Diagram(randomCircles(3000, 72));
  let calls = 0;
  const meddler = {
    moveTo() {
      if (++calls % 500 === 0) changing.insertMany(randomCircles(100, calls));
    },
    lineTo() {},
    bezierCurveTo() {},
    closePath() {},
  };
  changing.voronoi([-1000, -1000, 1000, 1000]).render(meddler);
  expect(changing.size).toBeGreaterThan(3000);
  expect(validate(changing)).toBeNull();
  const disposer = {
    ...meddler,
    moveTo() {
      changing.dispose();
    },
  };
  expect(() => changing.voronoi([-1000, -1000, 1000, 1000]).render(disposer)).toThrow(
    expect.objectContaining({ code: "disposed" }),
  );
});

test("what a context throws comes through, and the next drawing works", () => {
  const broken = new Recorder();
  broken.lineTo = () => {
    throw new RangeError("no ink");
  };
  expect(() => voronoi.render(broken)).toThrow("no ink");
  expect(voronoi.render(null, { digits: 0 }).length).toBeGreaterThan(100);
});

test("nothing to draw is an empty string", () => {
  const empty = new Diagram();
  expect([
    empty.render(),
    empty.renderSites(),
    empty.renderHull(),
    empty.voronoi().render(),
  ]).toEqual(["", "", "", ""]);
  expect([...empty.hull()]).toEqual([]);
  expect([...new Diagram([1, 2, 3]).hull()]).toEqual([0]);
  expect(empty.voronoi().renderBounds()).toBe("M0,0L960,0L960,500L0,500Z");
});

test("the hull goes counter-clockwise and lists a site as often as it touches it", () => {
  const large = new Diagram([0, 0, 10, 10, 0, 1, 0, 10, 1, -10, 0, 1]);
  const hull = [...large.hull()];
  const start = hull.indexOf(1);
  expect([...hull.slice(start), ...hull.slice(0, start)]).toEqual([1, 0, 2, 0, 3, 0]);
});
