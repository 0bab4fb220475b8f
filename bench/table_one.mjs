// Table 1 of the paper beside our numbers: T/(n log h), logarithm to base 10, T in seconds. The
// paper's computer was a Pentium III with 1 GHz; what can be compared is how the columns change
// from row to row.
import { tableOneFamilies } from "./plan.mjs";
import { table } from "./tables.mjs";

/** n, h/n, and the paper's last two columns in units of 1e-4 s (null: the paper gives none). */
const paper = [
  [1e3, "1.00", 1.1, 1.1],
  [1e3, "0.95", 1.18, 1.24],
  [1e3, "0.80", 1.14, 1.27],
  [1e3, "0.50", 0.96, 1.07],
  [1e4, "1.00", 1.18, 0.9],
  [1e4, "0.95", 1.16, 0.95],
  [1e4, "0.80", 1.14, 0.94],
  [1e4, "0.50", 0.98, 0.82],
  [1e5, "1.00", 1.7, 0.77],
  [1e5, "0.95", 1.75, 0.81],
  [1e5, "0.80", 1.7, 0.79],
  [1e5, "0.50", 1.43, 0.68],
  [1e6, "1.00", null, 0.71],
  [1e6, "0.95", null, 0.75],
  [1e6, "0.80", 3.61, 0.75],
  [1e6, "0.50", 3.01, 0.68],
];

export function tableOne(records) {
  const rows = paper.map(([n, ratio, paperWalk, paperHierarchy]) => {
    const family = Object.entries(tableOneFamilies).find(
      ([key]) => Number(key) === Number(ratio),
    )[1];
    const of = (op, contender) =>
      records.find(
        (record) =>
          record.part === "table1" &&
          record.family === family &&
          record.n === n &&
          record.op === op &&
          record.contender === contender,
      );
    const h = of("insert", "native")?.visible;
    const seconds = (record) =>
      record?.us === undefined
        ? ""
        : `${((record.us * n) / 1e6).toPrecision(3)}${record.isCutOff ? "*" : ""}`;
    // T = n · us · 1e-6, so T/(n log h) = us · 1e-6 / log h.
    const scaled = (record) =>
      record?.us === undefined ? "" : ((record.us * 10) / Math.log10(h)).toFixed(2);
    const [walk, hierarchy, wasm] = [
      of("insertByWalk", "native"),
      of("insert", "native"),
      of("insert", "wasm"),
    ];
    return [
      n,
      h ?? "",
      ratio,
      seconds(walk),
      seconds(hierarchy),
      seconds(wasm),
      scaled(walk),
      scaled(hierarchy),
      scaled(wasm),
      paperWalk ?? "—",
      paperHierarchy,
    ];
  });
  return table(
    [
      "n",
      "h",
      "h/n",
      "T1 s",
      "T2 s",
      "T2 s wasm",
      "T1/(n log h) e-7",
      "T2/(n log h) e-7",
      "wasm e-7",
      "paper T1 e-4",
      "paper T2 e-4",
    ],
    rows.filter(([, h]) => h !== ""),
  );
}
