// npm run bench: builds all contenders, measures, prints one report, and writes it with its
// picture. Options: README.md. A whole run writes what documents quote of it to docs/figures.json.
import { mkdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { parseArgs } from "node:util";
import { fileURLToPath } from "node:url";
import { run, SetUpError } from "../tools/toolchain/process.mjs";
import { buildPackage } from "../tools/build.mjs";
import { recordFigures } from "../tools/figures.mjs";
import { main } from "../tools/toolchain/setup.mjs";
import { measureCluster } from "./cluster.mjs";
import { names, stopAll } from "./contenders.mjs";
import { figuresOf } from "./figures.mjs";
import { machine } from "./machine.mjs";
import { disagreements, runScenes } from "./measure.mjs";
import { picture } from "./picture.mjs";
import { drafts, results } from "./places.mjs";
import { modeNames, parts, scenesOf } from "./plan.mjs";
import { buildContenders, hasCgal } from "./prepare.mjs";
import { report } from "./report.mjs";

function options() {
  const { values } = parseArgs({
    options: {
      quick: { type: "boolean" },
      full: { type: "boolean" },
      only: { type: "string" },
      without: { type: "string", multiple: true },
    },
  });
  const mode = modeNames.find((name) => values[name]) ?? "default";
  const { only, without = [] } = values;
  if (only && only !== "page" && !parts[only])
    throw new SetUpError(`no part ${only}: there are ${Object.keys(parts).join(", ")}, page`);
  const stranger = without.find((name) => !names.includes(name));
  if (stranger) throw new SetUpError(`no contender ${stranger}: there are ${names.join(", ")}`);
  return { mode, only, without };
}

function progress(share, text) {
  if (process.stderr.isTTY)
    process.stderr.write(`\r\x1b[K${(100 * share).toFixed(0).padStart(3)} %  ${text}`);
}

/** All contenders, in one report. */
async function contenders() {
  const { mode, only, without } = options();
  if (only === "page") {
    await buildPackage();
    run(process.execPath, [fileURLToPath(new URL("js/page.mjs", import.meta.url))]);
    return;
  }
  await buildContenders();
  const isThere = (name) => (name !== "cgal" || hasCgal) && !without.includes(name);
  const facts = machine();
  const start = performance.now();
  let records;
  try {
    records = await runScenes(scenesOf(mode, only), isThere, progress);
  } finally {
    stopAll();
  }
  progress(1, "\n");
  const seconds = (performance.now() - start) / 1000;
  const result = {
    machine: facts,
    mode,
    seconds: Math.round(seconds),
    records,
    disagreements: disagreements(records),
  };
  const text = report({ ...result, seconds });
  console.log(text);

  const isWhole = mode !== "quick" && !only && without.length === 0;
  const folder = isWhole ? results : drafts;
  for (const one of [folder, drafts]) mkdirSync(one, { recursive: true });
  const { cpu, cores, node, commit, date } = facts;
  writeFileSync(path.join(drafts, "latest.json"), `${JSON.stringify(result, null, 1)}\n`);
  writeFileSync(path.join(folder, "latest.md"), text);
  writeFileSync(
    path.join(folder, "latest.svg"),
    picture(records, `${cpu}, ${cores} cores; Node ${node}; commit ${commit}; ${date}`),
  );
  if (isWhole) recordFigures("bench", figuresOf(result)); // the documents quote them
  console.log(`Written to ${path.relative(process.cwd(), folder)}/latest.{md,svg}`);
}

const [part, ...rest] = process.argv.slice(2);
await main(() => (part === "cluster" ? measureCluster(rest) : contenders()));
