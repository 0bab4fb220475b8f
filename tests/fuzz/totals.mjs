// What fuzzing has run, added up over runs and by the state of src/.
import { createHash } from "node:crypto";
import { existsSync, readdirSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import path from "node:path";
import { root } from "../../tools/toolchain/folders.mjs";

/** Of all files of src/, in an order of their own. */
export function digestOfSources() {
  const hash = createHash("sha256");
  const folder = path.join(root, "src");
  for (const file of readdirSync(folder, { recursive: true }).map(String).sort()) {
    if (/\.(cpp|h)$/.test(file))
      hash
        .update(file)
        .update("\0")
        .update(readFileSync(path.join(folder, file)));
  }
  return hash.digest("hex").slice(0, 16);
}

/**
 * Adds a slice: { executions, seconds, coverage, findings }. Read and written at once, as another
 * run may do so too.
 */
export function addToTotals(file, digest, target, { executions, seconds, coverage, findings }) {
  const totals = existsSync(file) ? JSON.parse(readFileSync(file, "utf8")) : {};
  totals[digest] ??= {};
  totals[digest][target] ??= { executions: 0, seconds: 0, coverage: 0, findings: 0 };
  const sum = totals[digest][target];
  sum.executions += executions;
  sum.seconds = Math.round((sum.seconds + seconds) * 10) / 10;
  sum.coverage = Math.max(sum.coverage, coverage);
  sum.findings += findings.length;
  sum.last = new Date().toISOString();
  writeFileSync(`${file}.new`, `${JSON.stringify(totals, null, 2)}\n`);
  renameSync(`${file}.new`, file);
}

/** `done` maps targets to sums with their findings listed. */
export function printTable(done) {
  const rows = Object.entries(done).map(([target, { executions, seconds, coverage, findings }]) => [
    target,
    executions.toLocaleString("en"),
    seconds.toFixed(0),
    String(coverage),
    String(findings.length),
  ]);
  const table = [["target", "executions", "seconds", "coverage", "findings"], ...rows];
  const widths = table[0].map((_, column) => Math.max(...table.map((row) => row[column].length)));
  const line = (row) =>
    row.map((cell, k) => (k === 0 ? cell.padEnd(widths[k]) : cell.padStart(widths[k]))).join("  ");
  console.log(table.map(line).join("\n"));
  for (const { findings } of Object.values(done))
    for (const finding of findings) console.log(finding);
}
