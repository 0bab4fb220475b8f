// Treemaps: animation, slices and aborting, what is refused, types.
import { execFileSync } from "node:child_process";
import { mkdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { hierarchy } from "d3-hierarchy";
import * as consumer from "../../build/packed/consumer.mjs";
import * as entry from "../../build/packed/treemap.mjs";
import { root as repository } from "../../tools/toolchain/folders.mjs";
import { packed } from "./support/install_packed.mjs";
import { generator } from "./support/random.mjs";
import { expectRefusal, expectRejection } from "./support/refusal.mjs";
import { deviationOf, flare, flat, randomTree, rootOf } from "./support/trees.mjs";

const { treemap } = entry;
const box = [0, 0, 900, 500];
const bitsOf = (root) =>
  JSON.stringify(
    root
      .descendants()
      .map(({ area, centroid, polygon, site, fit }) => [area, centroid, polygon, site, fit]),
  );

test("the class of errors is the default entry's", () => {
  expect(entry.ApolloniusError).toBe(consumer.ApolloniusError);
});

test.each(["move", "stay"])("previous, sites %s: few steps a frame, and small motions", (sites) => {
  const random = generator(11);
  const sizes = new Map(
    hierarchy(flare)
      .leaves()
      .map(({ data }) => [data, data.size]),
  );
  const next = () =>
    hierarchy(flare)
      .sum((data) => sizes.get(data) ?? 0)
      .sort((a, b) => b.data.size - a.data.size);
  let before = treemap().shape(box).sites(sites)(next());
  const first = before.descendants().reduce((sum, { fit }) => sum + (fit?.iterations ?? 0), 0);
  for (let frame = 0; frame < 10; ++frame) {
    for (const [data, size] of sizes) sizes.set(data, size * (0.97 + 0.06 * random()));
    const root = treemap().shape(box).sites(sites).previous(before)(next());
    expect(deviationOf(root)).toBeLessThan(1e-6);
    const steps = root.descendants().flatMap(({ fit }) => fit?.iterations ?? []);
    expect(Math.max(...steps)).toBeLessThanOrEqual(4);
    expect(steps.reduce((a, b) => a + b)).toBeLessThan(first);
    const old = new Map(before.leaves().map((leaf) => [leaf.data, leaf]));
    for (const {
      data,
      centroid: [x, y],
      area,
    } of root.leaves()) {
      const [oldX, oldY] = old.get(data).centroid;
      // in widths of the cell, or where the whole drifts, of the picture
      expect(Math.hypot(x - oldX, y - oldY)).toBeLessThan(0.5 * Math.sqrt(area) + 10);
    }
    before = root;
  }
});

test("previous: the same root, other values; children that come and go; another shape", () => {
  const data = randomTree(60, 12);
  const root = treemap().shape(box)(rootOf(data));
  root.sum(({ size = 0, name }) => (name === "leaf 3" ? 0 : size * (name === "leaf 5" ? 2 : 1)));
  treemap().shape([0, 0, 800, 600]).previous(root)(root);
  expect(deviationOf(root)).toBeLessThan(1e-6);
  root.sum(({ size = 0 }) => size);
  treemap().shape({ x: 0, y: 0, r: 5 }).previous(root)(root);
  expect(deviationOf(root)).toBeLessThan(1e-6);
  const wholly = treemap()
    .previous(root)
    .key((_, k) => `other ${k}`)(rootOf(flare));
  expect(deviationOf(wholly)).toBeLessThan(1e-6);
});

describe("previous: which node is which", () => {
  const rows = Array.from({ length: 20 }, (_, k) => ({ key: `key ${k}`, v: 10 + ((k * 37) % 23) }));
  const later = (k) => 0.75 + ((k * 29) % 50) / 100;
  const sorted = (root) => root.sort((a, b) => b.value - a.value);
  const layout = () => treemap().shape(box);
  /** The leaves' centroids by what names them. */
  const placesOf = (root, nameOf) =>
    new Map(root.leaves().map((leaf) => [nameOf(leaf), leaf.centroid]));
  /** Trees of the same leaves before and after, in another order, and what names a leaf in both. */
  const rollupOf = (keyOf) => (factor) => {
    const sums = new Map(rows.map(({ v }, k) => [keyOf(k), v * factor(k)]));
    return sorted(hierarchy(sums).sum(([, v]) => (typeof v === "number" ? v : 0)));
  };
  /** Maps as d3.group makes them. */
  const groupsOf = (list, keyOf) => {
    const groups = new Map();
    for (const one of list) groups.set(keyOf(one), [...(groups.get(keyOf(one)) ?? []), one]);
    return groups;
  };
  const month = (k) => new Date(Date.UTC(2000, k));
  const cases = {
    "d3.rollup": [rollupOf((k) => `key ${k}`), ({ data }) => data[0]],
    "d3.rollup by numbers and by nothing": [rollupOf((k) => k || undefined), ({ data }) => data[0]],
    "d3.rollup by dates": [rollupOf(month), ({ data }) => Number(data[0])],
    "d3.group of the same rows": [
      (factor) => {
        const groups = groupsOf(rows, ({ v }) => v % 3);
        const factors = new Map(rows.map((row, k) => [row, row.v * factor(k)]));
        return sorted(hierarchy(groups).sum((data) => factors.get(data) ?? 0));
      },
      ({ data }) => data,
    ],
    "d3.group of names": [
      (factor) => {
        const names = rows.map(({ key }) => key);
        const groups = groupsOf(names, (key) => key.length);
        const factors = new Map(rows.map(({ key, v }, k) => [key, v * factor(k)]));
        return sorted(hierarchy(groups).sum((data) => factors.get(data) ?? 0));
      },
      ({ data }) => data,
    ],
    "the same tree, sorted again, of data without names": [
      (() => {
        const root = hierarchy({ children: rows.map(({ v }) => v) });
        const numbers = new Map(root.leaves().map((leaf, k) => [leaf, k]));
        return (factor) => {
          root.leaves().forEach((leaf) => {
            leaf.weight = leaf.data * factor(numbers.get(leaf));
          });
          root.eachAfter((node) => {
            node.value = node.weight ?? node.children.reduce((sum, { value }) => sum + value, 0);
          });
          return sorted(root);
        };
      })(),
      (leaf) => leaf,
    ],
  };

  test.each(Object.keys(cases))("%s", (name) => {
    const [tree, nameOf] = cases[name];
    const first = layout()(tree(() => 1));
    const before = placesOf(first, nameOf);
    const second = layout().previous(first)(tree(later));
    expect(deviationOf(second)).toBeLessThan(1e-6);
    const ways = Array.from(placesOf(second, nameOf), ([own, [x, y]]) => {
      const [oldX, oldY] = before.get(own);
      return Math.hypot(x - oldX, y - oldY);
    }).sort((a, b) => a - b);
    expect(ways.length).toBe(rows.length);
    expect(ways[10]).toBeLessThan(30); // 138 by their places in the order
  });

  const nameless = (sizes) => hierarchy({ children: sizes.map((size) => ({ size })) });
  const summed = (root) => root.sum(({ size = 0 }) => size);

  test("what cannot be told is refused, and nodes stay as they are", async () => {
    const before = layout()(summed(nameless([1, 2, 3])));
    for (const sizes of [[1, 2, 3], [3, 2, 1], [5]]) {
      const root = summed(nameless(sizes));
      const message = "children of a node have no names, and other data: treemap().key";
      expectRefusal(() => layout().previous(before)(root), "bad-option", message);
      await expectRejection(() => layout().previous(before).async(root), "bad-option", message);
      expect(root.children[0].polygon).toBe(undefined);
      const byIndex = layout()
        .previous(before)
        .key((_, index) => index)(root);
      expect(deviationOf(byIndex)).toBeLessThan(1e-6);
    }
    // [key, value] is a pair of d3.rollup only below a Map; here a name comes second.
    const pairs = (...children) =>
      hierarchy({ children }).sum((data) => (Array.isArray(data) ? data[0] : 0));
    const ofPairs = layout()(pairs([1, "a"], [2, "b"]));
    const exchanged = pairs([2, "a"], [1, "b"]);
    expectRefusal(() => layout().previous(ofPairs)(exchanged), "bad-option", "have no names");
    const rowsOf = (...list) => groupsOf(list, () => "all");
    const ofRows = (...list) =>
      hierarchy(rowsOf(...list)).sum(([size]) => (typeof size === "number" ? size : 0));
    const grouped = layout()(ofRows([1, "a"], [2, "b"]));
    expectRefusal(
      () => layout().previous(grouped)(ofRows([2, "a"], [1, "b"])),
      "bad-option",
      'children of node the string "all" have no names',
    );
    const numbers = (...children) => hierarchy({ children }).sum((d) => (d > 0 ? d : 0));
    const message = "have no names";
    const old = layout()(numbers(1, 2));
    expectRefusal(() => layout().previous(old)(numbers(1, 3)), "bad-option", message);
  });

  test("those without names may come, or may go", () => {
    const [a, b, c] = [{ size: 1 }, { size: 2 }, { size: 3 }];
    const of = (...children) => summed(hierarchy({ children }));
    let root = layout()(of(a, b));
    for (const next of [of(c, b, a), of(c), of(b, a, c)]) {
      root = layout().previous(root)(next);
      expect(deviationOf(root)).toBeLessThan(1e-6);
    }
    expect(() => layout().previous(root)(of(a, b, { size: 4 }))).toThrow("have no names");
  });

  test("siblings of one key are refused, on either side", () => {
    const of = (...names) =>
      summed(hierarchy({ name: "all", children: names.map((name) => ({ name, size: 1 })) }));
    const message =
      'children of node the string "all" have twice the key the string "a": treemap().key';
    const [twice, once] = [of("a", "b", "a"), of("a", "b", "c")];
    for (const root of [twice, once]) layout()(root);
    expectRefusal(() => layout().previous(twice)(once), "bad-option", message);
    expectRefusal(() => layout().previous(once)(twice), "bad-option", message);
    const none = layout()
      .previous(once)
      .key(() => undefined);
    expectRefusal(() => none(of("a", "b")), "bad-option", "have twice the key undefined");
    layout().previous(twice)(twice); // each with itself
  });
});

test("async: the same bits, with turns of the event loop; progress from 0 to 1", async () => {
  const data = randomTree(1500, 13);
  const atOnce = treemap().shape(box)(rootOf(data));
  let turns = 0;
  let isRunning = true;
  (function turn() {
    ++turns;
    if (isRunning) setImmediate(turn);
  })();
  const seen = [];
  const root = rootOf(data);
  const made = await treemap()
    .shape(box)
    .async(root, { onProgress: (done) => seen.push(done) });
  isRunning = false;
  expect(made).toBe(root);
  expect(bitsOf(root)).toBe(bitsOf(atOnce));
  expect(turns).toBeGreaterThan(5);
  expect(seen.length).toBeGreaterThan(5);
  expect(seen).toEqual([...seen].sort((a, b) => a - b));
  expect([seen[0] >= 0, seen.at(-1)]).toEqual([true, 1]);
});

test("aborting: before, and in the middle; nodes stay as they were", async () => {
  const root = treemap()(rootOf(randomTree(500, 14)));
  const before = bitsOf(root);
  const reason = new Error("enough");
  const early = treemap()
    .seed(1)
    .async(root, { signal: AbortSignal.abort(reason) });
  await expect(early).rejects.toBe(reason);
  const controller = new AbortController();
  const onProgress = () => controller.abort(reason);
  const late = treemap().seed(1).async(root, { signal: controller.signal, onProgress });
  await expect(late).rejects.toBe(reason);
  const failing = treemap().async(root, {
    onProgress() {
      throw reason;
    },
  });
  await expect(failing).rejects.toBe(reason);
  expect(bitsOf(root)).toBe(before);
});

test.each([
  ["negative", -1, "-1"],
  ["NaN", NaN, "NaN"],
  ["infinite", Infinity, "Infinity"],
  ["a string", "5", 'the string "5"'],
])("a value that is %s is refused, wherever it is", async (_, value, said) => {
  const data = {
    name: "all",
    children: [
      { name: "a", v: 1 },
      { name: "b", v: value },
    ],
  };
  const root = hierarchy(data).each((node) => Object.assign(node, { value: node.data.v ?? 1 }));
  const message = `the value of node the string "b" is ${said}`;
  expectRefusal(() => treemap()(root), "bad-target", message);
  await expectRejection(() => treemap().async(root), "bad-target", message);
  expectRefusal(() => treemap().value(({ v }) => v)(hierarchy(data)), "bad-target", message);
  expect(root.area).toBe(undefined);
});

test("what is missing is named: values, a root", () => {
  expectRefusal(() => treemap()(hierarchy(flare)), "bad-target", "root.sum(…) makes values");
  expectRefusal(() => treemap()(null), "bad-option", "root is null, expected a node");
  expectRefusal(() => treemap()(flare), "bad-option", "root is an object, expected a node");
});

test.each([
  ["shape", [[0, 0, 0, 1]], "bad-bounds", "xmin < xmax"],
  [
    "shape",
    [
      [
        [0, 0],
        [1, 1],
        [2, 2],
      ],
    ],
    "bad-bounds",
    "",
  ],
  ["shape", [{ x: 0, y: 0, r: 0 }], "bad-bounds", "r of the disc is 0"],
  ["shape", [{ x: 0, y: NaN, r: 1 }], "not-finite", "y of the disc is NaN"],
  ["shape", ["M0,0"], "bad-option", 'shape is the string "M0,0"'],
  ["value", [5], "bad-option", "value is 5, expected a function"],
  ["padding", ["1"], "not-finite", 'padding is the string "1"'],
  ["padding", [-1], "out-of-range", "is -1, expected 0 or more"],
  ["padding", [() => NaN], "not-finite", "padding of node"],
  ["sites", ["jump"], "bad-option", 'sites is the string "jump"'],
  ["rounds", [1.5], "out-of-range", "rounds is 1.5"],
  ["seed", [NaN], "not-finite", "seed is NaN"],
  ["position", [() => [1]], "not-finite", "y of the position of node"],
  ["position", [[0, 0]], "bad-option", "position is an array of 2"],
  ["previous", [5], "bad-option", "previous is 5"],
  ["key", ["id"], "bad-option", 'key is the string "id"'],
])("%s(%j) is refused", (name, given, code, message) => {
  const root = rootOf(flat([1, 2]));
  expectRefusal(() => treemap()[name](...given)(root), code, message);
  expect(root.children[0].polygon).toBe(undefined);
});

test("options that are unknown, and contexts that cannot draw, are refused", async () => {
  const root = treemap()(rootOf(flat([1, 2])));
  await expectRejection(() => treemap().async(root, { progress() {} }), "bad-option", "progress");
  await expectRejection(() => treemap().async(root, { signal: 1 }), "bad-option", "signal");
  expectRefusal(() => root.render({}), "bad-option", "context is an object without moveTo()");
  expectRefusal(() => root.render(null, { digits: 99 }), "out-of-range", "digits is 99");
  expectRefusal(() => root.render(null, { tolerance: 1 }), "bad-option", "tolerance");
});

test("methods say what is set, and return the layout", () => {
  const layout = treemap();
  const settings = {
    shape: box,
    value: () => 1,
    padding: 2,
    sites: "stay",
    rounds: 3,
    position: () => [1, 2],
    seed: 4,
    previous: null,
    key: null,
  };
  expect(layout.shape()).toEqual([0, 0, 1, 1]);
  for (const [name, value] of Object.entries(settings)) {
    expect(layout[name](value)).toBe(layout);
    expect(layout[name]()).toBe(value);
  }
});

test("types: nodes of d3-hierarchy come back as nodes with cells, on all levels", () => {
  const folder = path.join(packed, "treemap-types");
  mkdirSync(folder, { recursive: true });
  writeFileSync(
    path.join(folder, "use.ts"),
    `
import { treemap, type TreemapCell } from "apollonius-diagram/treemap";
// as @types/d3-hierarchy has it
declare class HierarchyNode<Datum> {
  data: Datum;
  readonly depth: number;
  readonly height: number;
  readonly parent: this | null;
  children?: this[] | undefined;
  readonly id?: string | undefined;
  readonly value?: number | undefined;
  leaves(): this[];
  sum(value: (d: Datum) => number): this;
}
interface File { name: string; size?: number }
declare const plain: HierarchyNode<File>;
const layout = treemap<File>().shape([0, 0, 2, 1]).value((d) => d.size).padding(3).seed(1)
  .position((node) => [node.data.name.length, 2]);
const root = layout(plain.sum((d) => d.size ?? 0));
const area: number = root.leaves()[0]!.area + root.children![0]!.children![0]!.area;
const polygon: [number, number][] | null = root.children![0]!.polygon;
const path: string = root.leaves()[0]!.render(null, { digits: 1 });
const cell: TreemapCell = root;
const depth: number = root.depth;
layout.previous(root);
async function slices() {
  const later = await layout.async(plain, { signal: new AbortController().signal });
  return later.leaves()[0]!.centroid?.[0];
}
// @ts-expect-error: no such sites
layout.sites("jump");
// @ts-expect-error: no node
layout({ name: "x" });
export { area, polygon, path, cell, depth, slices };
`,
  );
  const options = { strict: true, exactOptionalPropertyTypes: true, skipLibCheck: false };
  for (const moduleResolution of ["bundler", "nodenext"]) {
    const module = moduleResolution === "bundler" ? "esnext" : "nodenext";
    const compilerOptions = {
      ...options,
      module,
      moduleResolution,
      target: "es2022",
      noEmit: true,
    };
    const all = { ...compilerOptions, lib: ["es2022", "esnext.disposable", "dom"], types: [] };
    writeFileSync(
      path.join(folder, "tsconfig.json"),
      JSON.stringify({ compilerOptions: all, files: ["use.ts"] }),
    );
    const compiler = path.join(repository, "node_modules/typescript/bin/tsc");
    execFileSync(process.execPath, [compiler, "-p", folder], { encoding: "utf8" });
  }
});
