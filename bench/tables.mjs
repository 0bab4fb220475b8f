// Records as Markdown tables.
import { names } from "./contenders.mjs";

/** 0.00123, 0.123, 1.23, 12.3, 123. */
export function short(value) {
  if (value === undefined || Number.isNaN(value)) return "";
  if (value === 0) return "0";
  return value >= 99.5 ? value.toFixed(0) : value.toPrecision(3);
}

/** A Markdown table with padded columns: the first is text, the others are aligned to the right. */
export function table(head, rows) {
  const all = [head, ...rows].map((row) => row.map(String));
  const widths = head.map((_, k) => Math.max(3, ...all.map((row) => [...(row[k] ?? "")].length)));
  const pad = (text = "", k) => (k === 0 ? text.padEnd(widths[k]) : text.padStart(widths[k]));
  const line = (row) => `| ${widths.map((_, k) => pad(row[k], k)).join(" | ")} |`;
  const rules = widths.map((width, k) => `${"-".repeat(width + 1)}${k === 0 ? "-" : ":"}`);
  const rule = `|${rules.join("|")}|`;
  return [line(all[0]), rule, ...all.slice(1).map(line)].join("\n");
}

export const thousands = (n) => String(n).replace(/\B(?=(\d{3})+$)/g, " ");

function cell(record) {
  if (!record) return "";
  if (record.us === undefined) return record.error;
  const spread = record.samples > 1 ? ` (${short(record.fastest)}..${short(record.slowest)})` : "";
  return `${short(record.us)}${record.isCutOff ? "*" : ""}${spread}`;
}

/**
 * Microseconds per item: a row for each set and operation, a column for each contender that has a
 * number.
 */
export function timesTable(records) {
  const who = names.filter((name) => records.some(({ contender }) => contender === name));
  const rows = new Map();
  for (const record of records) {
    const key = [record.family, thousands(record.n), record.label, record.op]
      .filter(Boolean)
      .join(", ");
    rows.set(key, { ...rows.get(key), [record.contender]: record });
  }
  return table(
    ["set, operation: µs per item", ...who],
    [...rows].map(([key, row]) => [key, ...who.map((name) => cell(row[name]))]),
  );
}

/** Answers of each stage per item; only rows with answers beyond the cached circles. */
export function stagesTable(records) {
  const counted = records.filter(({ stages }) => stages && Object.keys(stages).length > 0);
  const stages = [...new Set(counted.flatMap((record) => Object.keys(record.stages)))];
  const rows = counted.map((record) => [
    `${record.family}, ${thousands(record.n)}, ${record.op}`,
    ...stages.map((stage) => short(record.stages[stage])),
  ]);
  return table(["set, operation: answers per item", ...stages], rows);
}

/** The number of visible sites of each set. */
export function visibleTable(records) {
  const rows = records
    .filter(({ op, contender }) => op === "build" && contender === "wasm")
    .map(({ family, n, visible }) => [
      family,
      thousands(n),
      thousands(visible ?? 0),
      short(visible / n),
    ]);
  return table(["family", "n", "h (visible)", "h/n"], rows);
}
