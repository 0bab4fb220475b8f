// The package of `npm run build -- --debug`: it runs, and a debugger sees C++.
import { readFileSync } from "node:fs";
import path from "node:path";
import { expect, test } from "@jest/globals";
import { hierarchy } from "d3-hierarchy";
import { packedDebug } from "../wasm/support/install_packed.mjs";

// Stands between the module and its environment, so that a test may stop a call within C++.
let stop;
WebAssembly.Instance = class extends WebAssembly.Instance {
  constructor(module, { env = {}, ...others }) {
    const resize = env.emscripten_resize_heap;
    const stoppable = { ...env, emscripten_resize_heap: (size) => (stop ?? resize)(size) };
    super(module, { ...others, env: stoppable });
  }
};

const { Diagram } = await import(path.join(packedDebug, "consumer.mjs"));
const { validate } = await import(path.join(packedDebug, "diagnostics.mjs"));
const { SphericalDiagram } = await import(path.join(packedDebug, "sphere.mjs"));
const { treemap } = await import(path.join(packedDebug, "treemap.mjs"));

const dist = path.join(packedDebug, "node_modules/apollonius-diagram/dist");

test("circles are inserted, found and removed; the cells fill the window", () => {
  const diagram = new Diagram([0, 0, 1, 5, 0, 2]);
  const id = diagram.insert(2, 4, 1);
  expect(Array.from(diagram.findMany([0, 0, 6, 0, 2, 5]))).toEqual([0, 1, id]);
  const areas = diagram.voronoi([-10, -10, 10, 10]).cellAreas();
  expect(areas.reduce((sum, area) => sum + area)).toBeCloseTo(400, 9);
  diagram.remove(id);
  expect(diagram.find(2, 5)).not.toBe(id);
  expect(validate(diagram)).toBeNull();
  expect(Diagram.fromBytes(diagram.toBytes()).size).toBe(2);
});

test("the sphere and treemaps, which work in the same module", () => {
  const sphere = new SphericalDiagram([0, 0, 0, 90, 0, 0.1]);
  expect([sphere.find(10, 0), sphere.find(80, 0)]).toEqual([0, 1]);
  expect(validate(sphere)).toBeNull();
  const root = hierarchy({ children: [{ value: 1 }, { value: 3 }] }).sum(({ value }) => value);
  const shape = [0, 0, 40, 10];
  const areas = treemap()
    .shape(shape)(root)
    .leaves()
    .map(({ area }) => area);
  expect(areas[0]).toBeCloseTo(100, 3);
  expect(areas[1]).toBeCloseTo(300, 3);
});

test("a stack trace has the names of C++ functions", () => {
  const circles = Float64Array.from({ length: 300_000 }, () => Math.random());
  const diagram = new Diagram();
  let cause;
  stop = () => {
    throw new Error("stopped");
  };
  try {
    diagram.insertMany(circles);
  } catch (error) {
    expect(error.code).toBe("broken");
    ({ cause } = error);
  } finally {
    stop = undefined;
  }
  expect(cause.message).toBe("stopped");
  expect(cause.stack).toMatch(/apollonius::.*\(wasm:/);
});

test("the source map lies where the module says, and names this repository's files", () => {
  const bytes = readFileSync(path.join(dist, "core.wasm"));
  const module = new WebAssembly.Module(bytes);
  const [section] = WebAssembly.Module.customSections(module, "sourceMappingURL");
  const address = Buffer.from(section).subarray(1).toString(); // after its length
  const { sources, mappings } = JSON.parse(readFileSync(path.join(dist, address), "utf8"));
  expect(mappings).not.toBe("");
  for (const file of ["src/delaunay/insert.cpp", "wasm/bindings/core.cpp"])
    expect(sources).toContain(`../../../${file}`); // as seen from build/debug/dist
});
