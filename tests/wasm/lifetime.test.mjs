// Lifetime: dispose, collection, and memory running out.
import { fileURLToPath } from "node:url";
import { transformSync } from "esbuild";
import { Diagram } from "../../build/packed/consumer.mjs";
import { validate } from "../../build/packed/diagnostics.mjs";
import { capture } from "../../tools/toolchain/process.mjs";
import { isThorough } from "../support/effort.mjs";
import { calls } from "./support/calls.mjs";
import { runInNode } from "./support/node.mjs";
import { randomCircles } from "./support/random.mjs";
import { expectRefusal, expectRejection } from "./support/refusal.mjs";

test.each(
  calls.filter(([name]) => !/\.(constructor|from|fromBytes)$/.test(name)),
)("%s after dispose is an error", async (name, { use, isAsync }) => {
  const expectDisposed = (call) =>
    (isAsync ? expectRejection : expectRefusal)(
      call,
      "disposed",
      "the diagram has been disposed of",
    );
  const diagram = new Diagram([0, 0, 1]);
  const view = diagram.voronoi();
  diagram.dispose();
  await expectDisposed(() => use(diagram));
  expectRefusal(() => [...diagram], "disposed", "the diagram has been disposed of");
  if (name.startsWith("Voronoi.")) await expectDisposed(() => use({ voronoi: () => view }));
});

test("a second dispose does nothing, and other diagrams live on", () => {
  const diagram = new Diagram([0, 0, 1]);
  const other = new Diagram(randomCircles(20, 31));
  diagram.dispose();
  diagram.dispose();
  expect(validate(other)).toBeNull();
});

// An array, an option or a context of the caller's can dispose of the diagram in the middle of a
// call.
const dispose = (d, value) => ({
  get 0() {
    d.dispose();
    return value;
  },
  length: 6,
  1: 1,
  2: 1,
  3: 2,
  4: 2,
  5: 1,
});
const option = (d, name) => ({
  get [name]() {
    d.dispose();
    return undefined;
  },
});
test.each([
  ["insertMany", (d) => d.insertMany(dispose(d, 1))],
  [
    "updateMany ids",
    (d) =>
      d.updateMany(
        {
          ...[0],
          length: 1,
          get 0() {
            d.dispose();
            return 0;
          },
        },
        [1, 2, 3],
      ),
  ],
  ["updateMany xyr", (d) => d.updateMany([0, 1], dispose(d, 1))],
  ["removeMany", (d) => d.removeMany(dispose(d, 0))],
  ["findMany", (d) => d.findMany(dispose(d, 1))],
  ...["tolerance", "digits"].flatMap((name) => [
    [`render, ${name}`, (d) => d.render(null, option(d, name))],
    [`renderSites, ${name}`, (d) => d.renderSites(null, option(d, name))],
    [`renderHull, ${name}`, (d) => d.renderHull(null, option(d, name))],
    [`voronoi().render, ${name}`, (d) => d.voronoi().render(null, option(d, name))],
    [`renderCell, ${name}`, (d) => d.voronoi().renderCell(0, null, option(d, name))],
  ]),
  ["cellPolygon", (d) => d.voronoi().cellPolygon(0, option(d, "tolerance"))],
  ["cellPolygon, flat", (d) => d.voronoi().cellPolygon(0, option(d, "flat"))],
  ["toGeoJSON", (d) => d.voronoi().toGeoJSON(option(d, "tolerance"))],
  ["fitAreas, targets", (d) => d.voronoi().fitAreas(dispose(d, 1))],
  [
    "fitAreas, targets by id",
    (d) =>
      d.voronoi().fitAreas({
        get 0() {
          d.dispose();
          return 1;
        },
        1: 1,
      }),
  ],
  ["fitAreas, tolerance", (d) => d.voronoi().fitAreas([1, 2], option(d, "tolerance"))],
])("disposed of during the call: %s", (_, call) => {
  const other = new Diagram(randomCircles(20, 32));
  expectRefusal(() => call(new Diagram([0, 0, 1, 5, 5, 1])), "disposed", "disposed of");
  expect(validate(other)).toBeNull();
});

const windows = [
  ["a rectangle", [0, 0, 90, 90]],
  ["a region", [0, 0, 90, 0, 95, 90, 0, 80]],
];
describe.each(
  windows,
)("a view of %s that is disposed of, while its diagram lives on", (_, window) => {
  test.each(calls.filter(([name]) => name.startsWith("Voronoi.")))("%s", async (__, call) => {
    const diagram = new Diagram([0, 0, 1, 50, 60, 2]);
    const [view, other] = [diagram.voronoi(window), diagram.voronoi(window)];
    view.dispose();
    view.dispose();
    await (call.isAsync ? expectRejection : expectRefusal)(
      () => call.use({ voronoi: () => view }),
      "disposed",
      "the view has been disposed of",
    );
    expect(other.cellArea(1)).toBeGreaterThan(0);
    expect(validate(diagram)).toBeNull();
  });

  // By an option or a callback. The call ends in a known way, and never breaks the diagram.
  test.each([
    ["render", (v) => v.render(null, option(v, "tolerance"))],
    ["renderBounds", (v) => v.renderBounds(null, option(v, "digits"))],
    ["renderCell", (v) => v.renderCell(0, null, option(v, "tolerance"))],
    ["cellPolygon", (v) => v.cellPolygon(0, option(v, "tolerance"))],
    ["cellPolygons", (v) => [...v.cellPolygons()].forEach(() => v.dispose())],
    ["toGeoJSON", (v) => v.toGeoJSON(option(v, "tolerance"))],
    ["toGeoJSON, properties", (v) => v.toGeoJSON({ properties: () => v.dispose() })],
    ["fitAreas, targets", (v) => v.fitAreas(Object.assign(dispose(v, 1), { length: 2 }))],
    ["fitAreas, tolerance", (v) => v.fitAreas([1, 2], option(v, "tolerance"))],
    ["fitAreas, onIteration", (v) => v.fitAreas([1, 2], { onIteration: () => v.dispose() })],
  ])("during %s", (__, call) => {
    const diagram = new Diagram([0, 0, 1, 50, 60, 2]);
    try {
      call(diagram.voronoi(window));
    } catch (error) {
      expectRefusal(
        () => {
          throw error;
        },
        "disposed",
        "disposed of",
      );
    }
    expect(validate(diagram)).toBeNull();
    expect(diagram.voronoi(window).cellArea(1)).toBeGreaterThan(0);
  });

  test("by Symbol.dispose, too", () => {
    const view = new Diagram([0, 0, 1]).voronoi(window);
    view[Symbol.dispose]();
    expectRefusal(() => view.cellAreas(), "disposed", "the view has been disposed of");
  });
});

test("Symbol.dispose disposes", () => {
  const diagram = new Diagram();
  diagram[Symbol.dispose]();
  expect(() => diagram.size).toThrow(expect.objectContaining({ code: "disposed" }));
});

test("`using` disposes at the end of the block, whatever ends it", () => {
  const source = `
    import { Diagram } from "apollonius-diagram";
    const seen = [];
    try {
      using diagram = new Diagram([0, 0, 1]);
      seen.push(diagram);
      throw new Error("early");
    } catch {}
    try { seen[0].size; } catch (error) { console.log(error.code); }`;
  // Node 20 does not know `using` yet.
  const { code } = transformSync(source, { target: "es2022", format: "esm" });
  expect(runInNode(code)).toBe("disposed");
});

test("disposed memory is used again", () => {
  const output = runInNode(`
    let grown = 0;
    const grow = WebAssembly.Memory.prototype.grow;
    WebAssembly.Memory.prototype.grow = function (pages) {
      ++grown;
      return grow.call(this, pages);
    };
    const { Diagram } = await import("apollonius-diagram");
    const xyr = Float64Array.from(
      { length: 120_000 }, (_, k) => (k % 3 === 2 ? 1 : Math.random() * 1e6));
    for (let k = 0; k < 3; ++k) new Diagram(xyr).dispose();
    const before = grown;
    for (let k = 0; k < 8; ++k) new Diagram(xyr).dispose();
    console.log(grown - before);
  `);
  expect(output).toBe("0");
});

// The memory itself, as the module sees it: what WebAssembly.Memory.grow was called for.
const watchGrowth = `
    let pages = 0;
    const grow = WebAssembly.Memory.prototype.grow;
    WebAssembly.Memory.prototype.grow = function (more) {
      pages += more;
      return grow.call(this, more);
    };
    const { Diagram } = await import("apollonius-diagram");`;

test("200 000 diagrams, made and disposed of, need the memory of a few", () => {
  const output = runInNode(`${watchGrowth}
    for (let k = 0; k < 200_000; ++k) {
      if (k % 3 === 0) {
        using(new Diagram([k, 0, 1, k + 5, 5, 1]));
      } else {
        const diagram = new Diagram();
        diagram.insert(k, 1, 2);
        diagram.dispose();
      }
      if (k === 1000) pages = 0;
    }
    function using(diagram) { diagram.find(0, 0); diagram[Symbol.dispose](); }
    console.log(pages);`);
  expect(output).toBe("0");
});

test("forgotten diagrams give their memory back", () => {
  const output = runInNode(
    `${watchGrowth}
    const xyr = Float64Array.from(
      { length: 900 }, (_, k) => (k % 3 === 2 ? 1 : (k * 7919) % 10007));
    const rounds = [];
    for (let round = 0; round < 12; ++round) {
      for (let k = 0; k < 20; ++k) new Diagram(xyr).find(0, 0);
      gc();
      await new Promise((resolve) => setTimeout(resolve, 20));  // finalizers run between tasks
      rounds.push(pages);
    }
    console.log(rounds.at(-1) - rounds[5]);`,
    ["--expose-gc"],
  );
  expect(output).toBe("0");
});

// Without a call of gc(): the engine has to find out by itself how much there is to collect.
test.each([
  ["of 3 sites", 100_000, 800, "new Diagram(xyr.subarray(0, 9))"],
  [
    "filled one by one",
    30_000,
    130,
    "const d = new Diagram(); for (let k = 0; k < 300; k += 3) d.insert(xyr[k], xyr[k + 1], 1)",
  ],
])("the engine knows what forgotten diagrams weigh: %s", (_, count, megabytes, make) => {
  const output = runInNode(`${watchGrowth}
    const xyr = Float64Array.from(
      { length: 900 }, (_, k) => (k % 3 === 2 ? 1 : (k * 7919) % 10007));
    for (let k = 0; k < ${count}; ++k) {
      { ${make}; }
      if (k % 20 === 0) await new Promise((resolve) => setImmediate(resolve));
    }
    console.log(pages / 16);`);
  expect(Number(output)).toBeGreaterThan(0);
  expect(Number(output)).toBeLessThan(megabytes); // without ballast it is twice as much
});

test("views of small regions weigh little beside the diagram, and nothing when disposed of", () => {
  const output = runInNode(`${watchGrowth}
    const n = 10_000;
    const xyr = Float64Array.from(
      { length: 3 * n }, (_, k) => (k % 3 === 2 ? 1 : (k * 7919 * (k % 3 + 1)) % 1_000_003));
    const diagram = new Diagram(xyr);
    const triangle = (k) => diagram.voronoi([[k, k], [k + 9, k], [k, k + 9]]);
    triangle(0).cellAreas();
    const megabytes = () => { const grown = pages / 16; pages = 0; return grown; };
    megabytes();
    const asked = (k) => { const view = triangle(k); view.cellAreas(); return view; };
    const views = Array.from({ length: 400 }, (_, k) => asked(k));
    const held = megabytes();
    for (const view of views) view.dispose();
    for (let k = 0; k < 400; ++k) asked(k).dispose();
    console.log(held, megabytes(), views.length);`);
  const [held, later] = output.split(" ").map(Number);
  // a bit for each face, of which there are two for each site; it was 10 bytes for each site
  expect(held).toBeLessThan((400 * 10_000 * 0.4) / 2 ** 20);
  expect(later).toBe(0);
});

test("out of memory, the message tells how diagrams are freed", () => {
  const output = runInNode(`${watchGrowth}
    WebAssembly.Memory.prototype.grow = () => { throw new RangeError("no more memory"); };
    try {
      for (;;) new Diagram([0, 0, 1]);
    } catch (error) {
      console.log(error.code, error.message);
    }`);
  expect(output).toMatch(/^out-of-memory not enough memory.*dispose\(\).*`using`/);
});

test("a forgotten diagram is collected", () => {
  const output = runInNode(
    `
    let freed = 0;
    const Registry = globalThis.FinalizationRegistry;
    globalThis.FinalizationRegistry = class extends Registry {
      constructor(callback) { super((held) => { ++freed; callback(held); }); }
    };
    const { Diagram } = await import("apollonius-diagram");
    for (let k = 0; k < 100; ++k) new Diagram([0, 0, 1, 5, 5, 1]);
    for (let k = 0; k < 50 && freed < 90; ++k) {
      gc();
      await new Promise((resolve) => setTimeout(resolve, 10));
    }
    console.log(freed >= 90 ? "collected" : "only " + freed);
  `,
    ["--expose-gc"],
  );
  expect(output).toBe("collected");
});

test("a disposed diagram is not freed twice when it is collected", () => {
  const output = runInNode(
    `
    const { Diagram } = await import("apollonius-diagram");
    const { validate } = await import("apollonius-diagram/diagnostics");
    for (let k = 0; k < 100; ++k) new Diagram([0, 0, 1, 5, 5, 1]).dispose();
    const kept = new Diagram([0, 0, 1, 5, 5, 1, 9, 0, 2]);
    for (let k = 0; k < 10; ++k) { gc(); await new Promise((resolve) => setTimeout(resolve, 5)); }
    console.log(validate(kept));
  `,
    ["--expose-gc"],
  );
  expect(output).toBe("null");
});

test("out of memory is an error, and the diagram is as it was", () => {
  const output = runInNode(`
    const grow = WebAssembly.Memory.prototype.grow;
    const { Diagram, ApolloniusError } = await import("apollonius-diagram");
    const { validate } = await import("apollonius-diagram/diagnostics");
    const diagram = new Diagram();
    WebAssembly.Memory.prototype.grow = () => { throw new RangeError("no more memory"); };
    const failures = { one: 0, many: 0 };
    let seed = 1;
    const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647 * 1e6;
    for (let k = 0; k < 2_000_000; ++k) {
      const before = diagram.size;
      try {
        diagram.insert(random(), random(), 1);
      } catch (error) {
        if (!(error instanceof ApolloniusError) || error.code !== "out-of-memory") throw error;
        if (diagram.size !== before) throw new Error("changed");
        if (++failures.one === 3) break;
      }
    }
    const full = diagram.size;
    for (const count of [3e6, 6e6]) {
      try {
        diagram.insertMany(Float64Array.from({ length: count }, random));
      } catch (error) {
        if (error.code !== "out-of-memory") throw error;
        ++failures.many;
      }
      if (diagram.size !== full) throw new Error("changed");
    }
    WebAssembly.Memory.prototype.grow = grow;
    const broken = validate(diagram);
    diagram.insertMany(Float64Array.from({ length: 3e4 }, random));
    const grew = diagram.size - full;
    console.log(JSON.stringify({ ...failures, broken, grew, isFull: full > 1000 }));
  `);
  expect(JSON.parse(output)).toEqual({ one: 3, many: 2, broken: null, grew: 10000, isFull: true });
});

test("many small diagrams come and go", () => {
  const count = isThorough ? 1_000_000 : 100_000;
  for (let k = 0; k < count; ++k) {
    const diagram = new Diagram([0, 0, 1, 5, k % 7, 2, 9, 1, 1]);
    if (k % 10_000 === 0) expect(diagram.find(5, 1)).toBe(1);
    diagram.dispose();
  }
});

const thorough = isThorough ? test : test.skip; // 4 GB and half a minute
thorough("all memory that there is, and less again", () => {
  const program = fileURLToPath(new URL("support/all_memory.mjs", import.meta.url));
  expect(
    JSON.parse(capture(process.execPath, [program], { env: { NODE_OPTIONS: "" } })).wrong,
  ).toEqual([]);
});
