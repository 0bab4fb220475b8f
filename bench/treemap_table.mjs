// The table of treemaps: their time, and the deviation of areas from the prescribed ones.
import { short, table, thousands } from "./tables.mjs";

const kNames = {
  "wasm treemapMove": "`treemap`, sites move",
  "wasm treemapStay": "`treemap`, sites stay",
  "wasm treemapLabels": "labels of all leaves, after that",
};
const kTrees = { flare: "Flare's classes", tree: "lognormal, groups of 5 to 12" };

const milliseconds = (us, items) => short((us * items) / 1e3);

export function treemapTable(records) {
  const rows = records.map(({ family, n, op, contender, us, fastest, items, deviation, error }) => [
    `${thousands(n)}, ${kTrees[family]}`,
    kNames[`${contender} ${op}`] ?? contender,
    us === undefined ? error : `${milliseconds(us, items)} (${milliseconds(fastest, items)})`,
    deviation === undefined ? "" : deviation.toExponential(1),
  ]);
  const note =
    "Median and fastest time of a layout in 960 × 600, and the largest deviation of a leaf's " +
    "area from its share, relative to that. d3-voronoi-treemap has straight edges and ends " +
    "after 50 rounds, or where all areas of siblings together are off by 1 % of their parent's.";
  return `${note}\n\n${table(["leaves", "by", "ms", "deviation"], rows)}`;
}
