// Treemaps: animation, slices and aborting, refusals, types.
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
      .map(({ area, centroid, polygon, circle, fit }) => [area, centroid, polygon, circle, fit]),
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
    const root = treemap().shape(box).sites(sites)(next(), { previous: before });
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
  treemap().shape([0, 0, 800, 600])(root, { previous: root });
  expect(deviationOf(root)).toBeLessThan(1e-6);
  root.sum(({ size = 0 }) => size);
  treemap().shape({ x: 0, y: 0, r: 5 })(root, { previous: root });
  expect(deviationOf(root)).toBeLessThan(1e-6);
  const wholly = treemap().key((_, k) => `other ${k}`)(rootOf(flare), { previous: root });
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
    const second = layout()(tree(later), { previous: first });
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
      const options = { previous: before };
      expectRefusal(() => layout()(root, options), "bad-option", message);
      await expectRejection(() => layout().async(root, options), "bad-option", message);
      expect(root.children[0].polygon).toBe(undefined);
      const byIndex = layout().key((_, index) => index)(root, options);
      expect(deviationOf(byIndex)).toBeLessThan(1e-6);
    }
    // [key, value] is a pair of d3.rollup only below a Map; here a name comes second.
    const pairs = (...children) =>
      hierarchy({ children }).sum((data) => (Array.isArray(data) ? data[0] : 0));
    const ofPairs = layout()(pairs([1, "a"], [2, "b"]));
    const exchanged = pairs([2, "a"], [1, "b"]);
    expectRefusal(() => layout()(exchanged, { previous: ofPairs }), "bad-option", "have no names");
    const rowsOf = (...list) => groupsOf(list, () => "all");
    const ofRows = (...list) =>
      hierarchy(rowsOf(...list)).sum(([size]) => (typeof size === "number" ? size : 0));
    const grouped = layout()(ofRows([1, "a"], [2, "b"]));
    expectRefusal(
      () => layout()(ofRows([2, "a"], [1, "b"]), { previous: grouped }),
      "bad-option",
      'children of node the string "all" have no names',
    );
    const numbers = (...children) => hierarchy({ children }).sum((d) => (d > 0 ? d : 0));
    const message = "have no names";
    const old = layout()(numbers(1, 2));
    expectRefusal(() => layout()(numbers(1, 3), { previous: old }), "bad-option", message);
  });

  test("those without names may come, or may go", () => {
    const [a, b, c] = [{ size: 1 }, { size: 2 }, { size: 3 }];
    const of = (...children) => summed(hierarchy({ children }));
    let root = layout()(of(a, b));
    for (const next of [of(c, b, a), of(c), of(b, a, c)]) {
      root = layout()(next, { previous: root });
      expect(deviationOf(root)).toBeLessThan(1e-6);
    }
    expect(() => layout()(of(a, b, { size: 4 }), { previous: root })).toThrow("have no names");
  });

  test("siblings of one key are refused, on either side", () => {
    const of = (...names) =>
      summed(hierarchy({ name: "all", children: names.map((name) => ({ name, size: 1 })) }));
    const message =
      'children of node the string "all" have twice the key the string "a": treemap().key';
    const [twice, once] = [of("a", "b", "a"), of("a", "b", "c")];
    for (const root of [twice, once]) layout()(root);
    expectRefusal(() => layout()(once, { previous: twice }), "bad-option", message);
    expectRefusal(() => layout()(twice, { previous: once }), "bad-option", message);
    const none = layout().key(() => undefined);
    const named = () => none(of("a", "b"), { previous: once });
    expectRefusal(named, "bad-option", "have twice the key undefined");
    layout()(twice, { previous: twice }); // each with itself
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

const line = [
  [0, 0],
  [1, 1],
  [2, 2],
];
test.each([
  ["shape", [0, 0, 0, 1], "bad-bounds", "xmin < xmax"],
  ["shape", [0, 0, 1], "bad-bounds", "bounds is an array of 3"],
  ["shape", [0, 0, 1, NaN], "bad-bounds", "ymax of bounds is NaN"],
  ["shape", line, "bad-bounds", "the region has no area"],
  ["shape", line.slice(1), "bad-bounds", "ring 0 of the region has 2 points"],
  ["shape", { type: "Point" }, "bad-bounds", "an object of type Point"],
  ["shape", {}, "bad-bounds", "bounds is an object"],
  ["shape", { x: 0, y: 0, r: 0 }, "bad-bounds", "r of the disc is 0"],
  ["shape", { x: 0, y: NaN, r: 1 }, "not-finite", "y of the disc is NaN"],
  ["shape", { x: 0, y: 0, r: 1e101 }, "out-of-range", "r of the disc is 1e+101"],
  ["shape", "M0,0", "bad-bounds", 'bounds is the string "M0,0"'],
  ["shape", null, "bad-bounds", "bounds is null"],
  ["size", [5, 0], "bad-bounds", "[0, 0, 5, 0]"],
  ["size", [-5, 1], "bad-bounds", "[0, 0, -5, 1]"],
  ["size", [NaN, 1], "bad-bounds", "xmax of bounds is NaN"],
  ["size", [5], "bad-bounds", "size is an array of 1, expected [width, height]"],
  ["size", 5, "bad-bounds", "size is 5, expected [width, height]"],
  ["value", 5, "bad-option", "value is 5, expected a function"],
  ["padding", "1", "not-finite", 'padding is the string "1"'],
  ["padding", -1, "out-of-range", "padding is -1, expected 0 or more"],
  ["padding", null, "not-finite", "padding is null"],
  ["sites", "jump", "bad-option", 'sites is the string "jump"'],
  ["rounds", 1.5, "out-of-range", "rounds is 1.5"],
  ["rounds", 1001, "out-of-range", "rounds is 1001, expected at most 1000"],
  ["seed", NaN, "not-finite", "seed is NaN"],
  ["position", [0, 0], "bad-option", "position is an array of 2"],
  ["key", "id", "bad-option", 'key is the string "id"'],
])("%s(%j) is refused when it is set, and what was set stays", (name, given, code, message) => {
  const layout = treemap();
  const before = layout[name]();
  expectRefusal(() => layout[name](given), code, message);
  expect(layout[name]()).toEqual(before);
  expect(layout(rootOf(flat([1, 2]))).area).toBe(1);
});

test.each([
  ["padding", () => NaN, "not-finite", 'padding of node the string "all" is NaN'],
  ["padding", () => -1, "out-of-range", 'padding of node the string "all" is -1, expected 0'],
  ["position", () => [1], "not-finite", "y of the position of node"],
  ["position", () => null, "not-finite", "x of the position of node"],
])("%s: what functions return is refused by the layout", (name, given, code, message) => {
  const root = rootOf(flat([1, 2]));
  expectRefusal(() => treemap()[name](given)(root), code, message);
  expect(root.children[0].polygon).toBe(undefined);
});

test("options that are unknown, and contexts that cannot draw, are refused", async () => {
  const root = treemap()(rootOf(flat([1, 2])));
  const refused = [
    [{ progress() {} }, "progress is unknown"],
    [{ prevous: root }, "prevous is unknown"],
    [root, "options.data is unknown"],
    [{ previous: 5 }, "previous is 5, expected a root with cells"],
    [{ previous: rootOf(flare) }, "previous is an object, expected a root with"],
    [{ previous: flare }, "previous is an object, expected a root with"],
  ];
  for (const [options, message] of refused) {
    expectRefusal(() => treemap()(root, options), "bad-option", message);
    await expectRejection(() => treemap().async(root, options), "bad-option", message);
  }
  expectRefusal(() => treemap()(root, { signal: undefined }), "bad-option", "signal is unknown");
  await expectRejection(() => treemap().async(root, { signal: 1 }), "bad-option", "signal");
  expectRefusal(() => root.render({}), "bad-option", "context is an object without moveTo()");
  expectRefusal(() => root.render(null, { digits: 99 }), "out-of-range", "digits is 99");
  expectRefusal(() => root.render(null, { tolerance: 0 }), "out-of-range", "tolerance is 0");
  expectRefusal(() => root.render(null, { tolerance: NaN }), "not-finite", "tolerance is NaN");
  expectRefusal(() => root.render(null, { width: 1 }), "bad-option", "width is unknown");
  expectRefusal(() => root.label({ aspect: 0 }), "out-of-range", "aspect is 0");
  expectRefusal(() => root.label({ ratio: 2 }), "bad-option", "ratio is unknown");
});

test("no previous layout: null and undefined; one without any cell", () => {
  const bits = bitsOf(treemap()(rootOf(flare)));
  const nothing = treemap()(rootOf({ name: "flare" }));
  for (const options of [undefined, null, {}, { previous: null }, { previous: undefined }])
    expect(bitsOf(treemap()(rootOf(flare), options))).toBe(bits);
  expect(bitsOf(treemap()(rootOf(flare), { previous: nothing }))).toBe(bits);
});

test("a layout keeps no tree: previous counts for one call", async () => {
  const layout = treemap();
  const first = layout(rootOf(flat([1, 2, 3])));
  const bits = bitsOf(layout(rootOf(flat([3, 1, 2]))));
  const options = { previous: first };
  const moved = bitsOf(layout(rootOf(flat([3, 1, 2])), options));
  expect(moved).not.toBe(bits);
  expect(bitsOf(await layout.async(rootOf(flat([3, 1, 2])), options))).toBe(moved);
  expect(bitsOf(layout(rootOf(flat([3, 1, 2]))))).toBe(bits);
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
    key: null,
  };
  expect(layout.shape()).toEqual([0, 0, 1, 1]);
  for (const [name, value] of Object.entries(settings)) {
    expect(layout[name](value)).toBe(layout);
    expect(layout[name]()).toBe(value);
  }
});

test("size: bounds from the origin on, and null for any other shape", () => {
  const layout = treemap();
  expect(layout.size()).toEqual([1, 1]);
  expect(layout.size(Float32Array.of(30, 20))).toBe(layout);
  expect([layout.size(), layout.shape()]).toEqual([
    [30, 20],
    [0, 0, 30, 20],
  ]);
  expect(layout(rootOf(flare)).area).toBe(600);
  const square = [0, 0, 0, 5, 5, 5, 5, 0];
  for (const shape of [{ x: 0, y: 0, r: 1 }, [0, 1, 2, 3], [1, 0, 2, 3], square]) {
    expect(layout.shape(shape).size()).toBe(null);
    expect(layout.shape()).toBe(shape);
  }
  expect(layout.shape([0, 0, 7, 8]).size()).toEqual([7, 8]);
});

test("a shape is read when it is set", () => {
  const triangle = [
    [0, 0],
    [4, 0],
    [0, 3],
  ];
  for (const [shape, area, spoilt] of [
    [[0, 0, 2, 1], 2, { 2: NaN }],
    [triangle, 6, { length: 1 }],
    [{ x: 0, y: 0, r: 2 }, 4 * Math.PI, { r: -1 }],
  ]) {
    const layout = treemap().shape(shape);
    Object.assign(shape, spoilt);
    const [first, second] = [1, 2].map(() => layout(rootOf(flat([1, 2, 3]))));
    expect(first.area).toBeCloseTo(area, 9);
    expect(first.fit.converged).toBe(true);
    expect(bitsOf(second)).toBe(bitsOf(first));
  }
});

test("types: nodes of d3-hierarchy, and plain ones, come back with cells, on all levels", () => {
  const folder = path.join(packed, "treemap-types");
  mkdirSync(folder, { recursive: true });
  writeFileSync(
    path.join(folder, "use.ts"),
    `
import {
  treemap, type Treemap, type TreemapCell, type TreemapNode, type TreemapShape, type WithCells,
} from "apollonius-diagram/treemap";
// as @types/d3-hierarchy has it
interface HierarchyNode<Datum> {
  new (data: Datum): this;
  data: Datum;
  readonly depth: number;
  readonly height: number;
  parent: this | null;
  children?: this[] | undefined;
  readonly id?: string | undefined;
  readonly value?: number | undefined;
  x?: number | undefined;
  leaves(): this[];
  find(filter: (node: this) => boolean): this | undefined;
  each<T = undefined>(visit: (this: T, node: this, index: number) => void, that?: T): this;
  sort(compare: (a: this, b: this) => number): this;
  sum(value: (d: Datum) => number): this;
  [Symbol.iterator](): Iterator<this>;
}
interface File { name: string; size?: number }
declare const root: HierarchyNode<File>;
declare const [w, h]: [number, number];
declare const c: CanvasRenderingContext2D;
for (const leaf of treemap().size([w, h])(root).leaves()) {
  const p = leaf.label({ aspect: 4 });
  if (p) c.fillText(leaf.data.name, p.x, p.y);
}

const layout = treemap<File>().shape([0, 0, 2, 1]).value((d) => d.size).padding(3).seed(1)
  .position((node) => [node.data.name.length, 2]);
const laid = layout(root.sum((d) => d.size ?? 0));
export const area: number = laid.leaves()[0]!.area + laid.children![0]!.children![0]!.area;
export const polygon: [number, number][] | null = laid.children![0]!.polygon;
export const path: string | null = laid.leaves()[0]!.render(null, { digits: 1, tolerance: 0.1 });
export const cell: TreemapCell = laid;
export const depth: number = laid.depth + laid.children![0]!.parent!.area;
declare const context: CanvasRenderingContext2D | null;
export const drawn: string | null | void = laid.render(context, { tolerance: 1 });
laid.find(({ area }) => area > 1)?.circle?.r.toFixed();
laid.each((node) => node.centroid?.[0].toFixed() ?? node.data.name);
for (const { fit } of laid) fit?.iterations.toFixed();
const size: [number, number] | null = layout.size();
const shapes: TreemapShape[] = [[0, 0, 1, 1], { x: 0, y: 0, r: 1 }, [[0, 0], [1, 0], [0, 1]]];

// Functions of d3's nodes.
const d3Layout: Treemap<File, HierarchyNode<File>> = treemap<File, HierarchyNode<File>>()
  .padding((node) => 8 - node.depth - (node.parent?.depth ?? 0))
  .position((node) => [node.height, node.leaves().length])
  .key((node, k) => node.parent?.data.name ?? k);
let last: WithCells<HierarchyNode<File>> | null = null;
for (let frame = 0; frame < 3; ++frame) last = d3Layout(root, { previous: last });
export async function slices() {
  const { signal } = new AbortController();
  const onProgress = (share: number) => share.toFixed();
  const later = await layout.async(root, { previous: laid, signal, onProgress });
  last = await d3Layout.async(root, { previous: last });
  return later.leaves()[0]!.centroid?.[0];
}

// Plain trees.
interface Plain { data: File; value: number; group: number; children?: Plain[] }
declare const plain: Plain;
const plainly = treemap<File>()(plain);
for (const child of plainly.children ?? []) {
  const p = child.label();
  if (p) c.fillText(child.data.name, p.x + child.group, p.y);
  for (const { area, group } of child.children ?? []) area + group;
}
const deep = plainly.children!.flatMap(({ children }) => children ?? []);
export const deepAreas: number[] = deep.map(({ area, group }) => area + group);
const same: Plain = plainly;
const again = treemap<File, Plain>().padding(({ group }) => group)(plain, { previous: plainly });
function visit(node: WithCells<Plain>): number {
  return node.children?.reduce((sum, child) => sum + visit(child), 0) ?? node.area;
}
visit(again);
const literal = treemap()({
  data: "all",
  value: 3,
  children: [{ data: "a", value: 1 }, { data: "b", value: 2, children: [{ data: "c", value: 2 }] }],
});
export const ofLiteral: number = literal.children[1]!.area;
declare const any: TreemapNode<File>;
treemap<File>()(any).children?.[0]?.children?.[0]?.area.toFixed();
class Own {
  data = "x";
  value = 1;
  children: Own[] = [];
  parent: Own | null = null;
}
export const ofOwn: number = treemap()(new Own()).children[0]!.parent!.area;
export const areaOf = <Node extends TreemapNode<File>>(node: Node) => treemap<File>()(node).area;

// @ts-expect-error: no such sites
layout.sites("jump");
// @ts-expect-error: no node
layout({ name: "x" });
// @ts-expect-error: other data
treemap<{ other: number }>()(root);
// @ts-expect-error: plain nodes have no depth
treemap<File>().padding((node) => 8 - node.depth);
// @ts-expect-error: not laid out
layout(root, { previous: root });
// @ts-expect-error: that one cannot be aborted
layout(root, { signal: new AbortController().signal });
// @ts-expect-error: a width and a height
layout.size([1, 2, 3]);
// @ts-expect-error: no such option
laid.label({ ratio: 2 });
export { size, shapes, same, slices as later };
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
      declaration: true,
      outDir: path.join(folder, "out"),
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
