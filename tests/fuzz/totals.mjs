// Totals of all fuzzing runs.
import { recordFigures } from "../../tools/figures.mjs";

/** Adds a slice to docs/figures.json: { executions, seconds, findings }. */
export function addToFigures(target, { executions, seconds, findings }) {
  recordFigures("fuzz", (before) => {
    const sum = before.targets[target] ?? { executions: 0, minutes: 0, findings: 0 };
    const own = {
      executions: sum.executions + executions,
      minutes: Math.round((sum.minutes + seconds / 60) * 10) / 10,
      findings: sum.findings + findings.length,
    };
    const targets = { ...before.targets, [target]: own };
    const total = (what) => Object.values(targets).reduce((all, one) => all + one[what], 0);
    const { earlier } = before; // runs whose time was not kept by target
    return {
      hours: Math.round(10 * earlier.hours + total("minutes") / 6) / 10,
      executions: total("executions"),
      findings: earlier.findings + total("findings"),
      earlier,
      targets,
    };
  });
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
