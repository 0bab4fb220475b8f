// Joins the parts of a run in their order:
//
//   node collect.mjs --folder work --out RESULT
//
// Every byte of every part is checked. Missing and damaged ones are named (the latter removed), and
// nothing is written; start submit.mjs (build.mjs) again, which has just these done again.
import { rename, rm } from "node:fs/promises";
import { parseArgs } from "node:util";
import { formats } from "./formats/index.mjs";
import { BadPart, listParts, readPart, removeDrafts, removePart } from "./parts.mjs";
import { readPlan } from "./run.mjs";
import * as tiles from "./tiles.mjs";

const { values: options } = parseArgs({
  options: { folder: { type: "string" }, out: { type: "string" } },
});
for (const name of ["folder", "out"]) if (!options[name]) throw new Error(`--${name} is missing`);
const { folder, out } = options;

const { kind, run, common, jobs } = readPlan(folder);
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
