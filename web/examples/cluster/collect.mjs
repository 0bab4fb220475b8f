// Joins the parts of a run in their order. Every byte of every part is checked; missing and damaged
// ones are named (the latter removed), and nothing is written.
import { rename, rm } from "node:fs/promises";
import { readOptions } from "./command_line.mjs";
import { formats } from "./formats/index.mjs";
import { BadPart, listParts, readPart, removeDrafts, removePart } from "./parts.mjs";
import { readPlan } from "./run.mjs";
import * as tiles from "./tiles.mjs";

const usage = `
node collect.mjs --folder work --out RESULT

Joins the parts that submit.mjs or build.mjs has had made, and checks each byte. If some are missing
or damaged, it names them and writes nothing: start submit.mjs (build.mjs) again, which has just
these done again.

  --folder   that of submit (build) and workers
  --out      what the names of the results begin with: RESULT.csv, RESULT.areas.f64, …`;

const { folder, out } = readOptions(usage, {
  folder: { type: "string", required: true },
  out: { type: "string", required: true },
});

const plan = readPlan(folder);
if (plan === undefined) throw new Error(`${folder} has no run: submit.mjs or build.mjs begins one`);
const { kind, run, common, jobs } = plan;
const bad = new Set();
const kMostNamed = 20;

/** The sections of all parts in order; those of bad ones are left out, and counted. */
async function* parts() {
  for (let index = 0; index < jobs.length; ++index) {
    try {
      yield await readPart(folder, run, index);
    } catch (error) {
      if (!(error instanceof BadPart)) throw error;
      bad.add(index);
      await removePart(folder, index);
    }
  }
}

const strange = (await listParts(folder)).filter((index) => index >= jobs.length);
if (strange.length > 0) throw new Error(`parts that are not of this run: ${strange.join(", ")}`);

const { join } = kind === "tile" ? tiles : formats[common.format];
const drafts = await join(`${out}.draft`, parts, common);
if (bad.size > 0) {
  for (const draft of drafts) await rm(draft);
  const some = [...bad].slice(0, kMostNamed).join(", ") + (bad.size > kMostNamed ? ", …" : "");
  console.error(`Missing or damaged: ${bad.size} of ${jobs.length} parts (${some})`);
  process.exitCode = 1;
} else {
  await removeDrafts(folder);
  for (const draft of drafts) {
    const file = out + draft.slice(`${out}.draft`.length);
    await rename(draft, file);
    console.log(file);
  }
}
