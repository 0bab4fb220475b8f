// The whole report: one Markdown text, which the run also prints.
import { fitTable } from "./fit_table.mjs";
import { growthTables } from "./growth_table.mjs";
import { kWarmUp } from "./plan.mjs";
import { stagesTable, timesTable, visibleTable } from "./tables.mjs";
import { tableOne } from "./table_one.mjs";
import { treemapTable } from "./treemap_table.mjs";

const titles = {
  scaling: "Against the number of sites (random circles, 5 % hidden)",
  families: "Kinds of input",
  orders: "Sorted orders one by one, and sites that hide each other",
  moves: "10 000 moving sites (µs per site; `updateMany`: times 10 is ms per frame)",
  drawing:
    "Drawing all edges (d3-delaunay: of the centres' cells), areas of all cells (µs per site)",
  windows: "All areas in windows of other shapes (µs per site; *Anew*: the window is given anew)",
  sphere: "The sphere (d3-geo-voronoi: of the centres; µs per site, of `find` per point)",
  snapshots: "Snapshots (µs per site; threads: µs per point, all of them together)",
  border: "One call that does nothing else (µs)",
  memory: "Memory (µs per item; bytes below)",
};

function memoryLines(records) {
  const megabytes = (bytes) => `${(bytes / 2 ** 20).toFixed(1)} MiB`;
  return records.flatMap((record) => {
    const bytes = record.bytesPerSite?.toFixed(0);
    if (record.op === "memory" && record.bytesPerSite)
      return [`- ${record.n} sites at once: ${bytes} bytes of heap growth per site`];
    if (record.op === "churn" && record.bytesAfterAll) {
      return [
        `- heap with ${record.n} sites: ${megabytes(record.bytesAfterThousand)} after 1000 ` +
          "removals and insertions, " +
          `${megabytes(record.bytesAfterAll)} after ${record.items + 1000}`,
      ];
    }
    if (record.part === "scaling" && record.op === "build" && record.bytesPerSite) {
      return [`- ${record.n} sites natively: ${bytes} bytes allocated per site (no unused heap)`];
    }
    return [];
  });
}

export function report({ machine, mode, records, disagreements, seconds }) {
  const of = (part) => records.filter((record) => record.part === part && record.label !== kWarmUp);
  const sections = Object.entries(titles)
    .filter(([part]) => of(part).length > 0)
    .map(([part, title]) => {
      const text = [`## ${title}`, timesTable(of(part))];
      if (part === "families")
        text.push(
          visibleTable(of(part)),
          "Stages (native), without the answers from the circles cached with the faces:",
          stagesTable(of(part)),
        );
      if (part === "memory") text.push(memoryLines(records).join("\n"));
      return text.join("\n\n");
    });
  const table =
    of("table1").length > 0
      ? [`## Table 1 of the paper, one by one in random order\n\n${tableOne(records)}`]
      : [];
  const fits = of("fit").length > 0 ? [`## Prescribed areas\n\n${fitTable(of("fit"))}`] : [];
  const treemaps =
    of("treemap").length > 0 ? [`## Treemaps\n\n${treemapTable(of("treemap"))}`] : [];
  const growth =
    of("growth").length > 0 ? [`## Growth of calls\n\n${growthTables(of("growth"))}`] : [];
  const parts = [
    "# Benchmark results",
    Object.entries(machine)
      .map(([key, value]) => `- ${key}: ${value}`)
      .join("\n"),
    `Mode ${mode}, ${seconds.toFixed(0)} s. Median (fastest..slowest); * = cut off at the time ` +
      "limit and counted for what was done until then. wasm is the packed package in Node, " +
      "native the same C++ without it; delaunator, d3-delaunay and flatbush know points only.",
    ...(disagreements.length > 0
      ? [`**Contenders disagree**:\n${disagreements.map((text) => `- ${text}`).join("\n")}`]
      : []),
    ...sections,
    ...fits,
    ...treemaps,
    ...growth,
    ...table,
  ];
  return `${parts.join("\n\n")}\n`;
}
