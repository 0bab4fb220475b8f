// Life time: dispose, collection, and memory running out.
import { transformSync } from "esbuild";
import { ApolloniusError, Diagram } from "../../build/packed/consumer.mjs";
import { runInNode } from "./support/node.mjs";
import { randomCircles } from "./support/random.mjs";

const uses = {
  insert: (d) => d.insert(1, 2, 3),
  insertMany: (d) => d.insertMany([1, 2, 3]),
  remove: (d) => d.remove(0),
  removeMany: (d) => d.removeMany([0]),
  update: (d) => d.update(0, 1, 2, 3),
  updateMany: (d) => d.updateMany([0], [1, 2, 3]),
  clear: (d) => d.clear(),
  size: (d) => d.size,
  visibleSize: (d) => d.visibleSize,
  hiddenSize: (d) => d.hiddenSize,
  has: (d) => d.has(0),
  site: (d) => d.site(0),
  ids: (d) => d.ids(),
  isHidden: (d) => d.isHidden(0),
  coverOf: (d) => d.coverOf(0),
  find: (d) => d.find(0, 0),
  nearest: (d) => d.nearest(0, 0),
  findMany: (d) => d.findMany([0, 0]),
  neighbors: (d) => d.neighbors(0),
  kNearest: (d) => d.kNearest(0, 0, 1),
  within: (d) => d.within(0, 0, 1),
  edges: (d) => d.edges(),
  vertices: (d) => d.vertices(),
  toBytes: (d) => d.toBytes(),
  validate: (d) => d.validate(),
  hull: (d) => d.hull(),
  voronoi: (d) => d.voronoi(),
  render: (d) => d.render(),
  renderSites: (d) => d.renderSites(),
  renderHull: (d) => d.renderHull(),
};

test("every member of the class is tried after dispose", () => {
  const members = Object.getOwnPropertyNames(Diagram.prototype).filter((name) => !["constructor", "dispose"].includes(name));
  expect(Object.keys(uses).sort()).toEqual(members.sort());
});

test.each(Object.entries(uses))("%s after dispose is an error", (_, use) => {
  const diagram = new Diagram([0, 0, 1]);
  diagram.dispose();
  expect(() => use(diagram)).toThrow(ApolloniusError);
  expect(() => use(diagram)).toThrow(expect.objectContaining({ code: "disposed" }));
});

test("a second dispose does nothing, and other diagrams live on", () => {
  const diagram = new Diagram([0, 0, 1]);
  const other = new Diagram(randomCircles(20, 31));
  diagram.dispose();
  diagram.dispose();
  expect(other.validate()).toBeNull();
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
  const { code } = transformSync(source, { target: "es2022", format: "esm" });  // Node 20 does not know `using` yet
  expect(runInNode(code)).toBe("disposed");
});

test("disposed memory is used again", () => {
  const output = runInNode(`
    let grown = 0;
    const grow = WebAssembly.Memory.prototype.grow;
    WebAssembly.Memory.prototype.grow = function (pages) { ++grown; return grow.call(this, pages); };
    const { Diagram } = await import("apollonius-diagram");
    const xyr = Float64Array.from({ length: 120_000 }, (_, k) => (k % 3 === 2 ? 1 : Math.random() * 1e6));
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
    WebAssembly.Memory.prototype.grow = function (more) { pages += more; return grow.call(this, more); };
    const { Diagram } = await import("apollonius-diagram");`;

test("a million diagrams, made and disposed of, need the memory of a few", () => {
  const output = runInNode(`${watchGrowth}
    for (let k = 0; k < 1_000_000; ++k) {
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
}, 120_000);

test("forgotten diagrams give their memory back", () => {
  const output = runInNode(`${watchGrowth}
    const xyr = Float64Array.from({ length: 900 }, (_, k) => (k % 3 === 2 ? 1 : (k * 7919) % 10007));
    const rounds = [];
    for (let round = 0; round < 12; ++round) {
      for (let k = 0; k < 20; ++k) new Diagram(xyr).find(0, 0);
      gc();
      await new Promise((resolve) => setTimeout(resolve, 20));  // finalizers run between tasks
      rounds.push(pages);
    }
    console.log(rounds.at(-1) - rounds[5]);`, ["--expose-gc"]);
  expect(output).toBe("0");
});

test("a forgotten diagram is collected", () => {
  const output = runInNode(`
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
  `, ["--expose-gc"]);
  expect(output).toBe("collected");
});

test("a disposed diagram is not freed twice when it is collected", () => {
  const output = runInNode(`
    const { Diagram } = await import("apollonius-diagram");
    for (let k = 0; k < 100; ++k) new Diagram([0, 0, 1, 5, 5, 1]).dispose();
    const kept = new Diagram([0, 0, 1, 5, 5, 1, 9, 0, 2]);
    for (let k = 0; k < 10; ++k) { gc(); await new Promise((resolve) => setTimeout(resolve, 5)); }
    console.log(kept.validate());
  `, ["--expose-gc"]);
  expect(output).toBe("null");
});

test("out of memory is an error, and the diagram is as it was", () => {
  const output = runInNode(`
    const grow = WebAssembly.Memory.prototype.grow;
    const { Diagram, ApolloniusError } = await import("apollonius-diagram");
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
    const broken = diagram.validate();
    diagram.insertMany(Float64Array.from({ length: 3e4 }, random));
    console.log(JSON.stringify({ ...failures, broken, grew: diagram.size - full, isFull: full > 1000 }));
  `);
  expect(JSON.parse(output)).toEqual({ one: 3, many: 2, broken: null, grew: 10000, isFull: true });
}, 120_000);
