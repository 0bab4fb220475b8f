// The table of growth: how calls grow from one size to another, beside the reference's promise.
import { readFileSync } from "node:fs";
import path from "node:path";
import { root } from "./places.mjs";
import { short, table, thousands } from "./tables.mjs";

/** Growth of this many times the promised one is marked. */
const kTolerance = 1.5;

function groupsBy(records, keyOf) {
  const groups = new Map();
  for (const record of records) {
    const key = keyOf(record);
    groups.set(key, [...(groups.get(key) ?? []), record]);
  }
  return groups;
}

/** The growth of one call in one family, of its time and of its cost; an error is a text. */
function growthOf(records) {
  const [small, large] = records.toSorted((a, b) => a.n - b.n);
  const error = small.error ?? large?.error;
  if (error !== undefined || !large) return { error: error ?? "" };
  const measured = large.us / small.us;
  const promised = large.cost / small.cost;
  // Both, as a busy machine disturbs the fastest samples less.
  const excess = Math.min(measured, large.fastest / small.fastest) / promised;
  return { measured, promised, isMarked: excess > kTolerance, small, large };
}

function grownTable(records, title) {
  const families = [...new Set(records.map(({ family }) => family))];
  const calls = groupsBy(records, ({ op }) => op);
  const errors = new Set();
  const rows = [...calls].map(([op, ofCall]) => {
    const found = families.map((family) => {
      const ofFamily = ofCall.filter((record) => record.family === family);
      return ofFamily.length === 0 ? {} : growthOf(ofFamily);
    });
    const promised = found.map((growth) => growth.promised).filter((value) => value !== undefined);
    const [least, most] = [Math.min(...promised), Math.max(...promised)].map((v) => v.toFixed(1));
    const cells = found.map(({ measured, error, isMarked }, k) => {
      if (error) errors.add(`${op}, ${families[k]}: ${error}`);
      if (error) return "error";
      return measured === undefined ? "" : `${measured.toFixed(1)}${isMarked ? "!" : ""}`;
    });
    const { promise } = ofCall.find((record) => record.promise) ?? { promise: "" };
    return [op, promise, least === most ? least : `${least} to ${most}`, ...cells];
  });
  const sizes = [...new Set(records.map(({ n }) => n))].sort((a, b) => a - b).map(thousands);
  const text = [
    `${title}: sites or points ${sizes.join(", ")}`,
    table(["call", "promised", "growth", ...families], rows),
    [...errors].map((error) => `- ${error}`).join("\n"),
  ];
  return text.filter(Boolean).join("\n\n");
}

/** A line for each mark, with its times. */
function markedList(records) {
  const groups = groupsBy(records, ({ op, family }) => `${op}, ${family}`);
  return [...groups].flatMap(([key, group]) => {
    const { isMarked, measured, promised, small, large } = growthOf(group);
    if (!isMarked) return [];
    const times = [small, large].map(({ us, n }) => `${short(us)} µs at ${thousands(n)}`);
    const excess = (measured / promised).toFixed(1);
    return [`- ${key}: ${excess} times what is promised (${times.join(", ")})`];
  });
}

/** Calls under whose heading the reference gives a cost and for which nothing was measured. */
function missing(records) {
  const measured = new Set(records.map(({ op }) => op.replace(/[(:@].*/, "")));
  const text = readFileSync(path.join(root, "docs/API.md"), "utf8");
  return text.split(/^(?=#{2,4} )/m).flatMap((section) => {
    const [heading] = section.split("\n");
    const words = section.replace(/```.*?```/gs, "");
    if (!/^#### /.test(heading) || !/\bcosts?(?::|,| as)|\bO\(/i.test(words)) return [];
    const name = heading.slice(5).replace(/^new (\w+)$/, "$1.constructor");
    return measured.has(name) ? [] : [name];
  });
}

export function growthTables(records) {
  const isOfWindow = ({ op }) => op.endsWith(":window");
  const isOfTree = ({ op }) => op.startsWith("treemap.");
  const isOfDiagram = ({ op }) => /^(\w*[dD]iagram\b|enclose)/.test(op);
  const isOfView = ({ op }) => /^\w*[vV]oronoi\./.test(op) && !isOfWindow({ op });
  const tables = [
    ["Of diagrams", isOfDiagram],
    ["Of views", isOfView],
    ["Of windows", isOfWindow],
    ["Of trees", isOfTree],
  ];
  const marked = markedList(records);
  const left = missing(records);
  return [
    "Processor time at the largest size by that at the smallest, medians; `!` is more than " +
      `${kTolerance} times the promised growth, which is beside it: a range where it depends on ` +
      "what is found.",
    ...tables.map(([title, isOne]) => grownTable(records.filter(isOne), title)),
    ...(marked.length > 0 ? [marked.join("\n")] : []),
    ...(left.length > 0 ? [`Not measured: ${left.join(", ")}.`] : []),
  ].join("\n\n");
}
