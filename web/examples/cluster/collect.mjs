// Joins the parts of a run in their order. Every byte of every part is checked; missing and damaged
// ones are named (the latter removed), and nothing is written.
import { mkdir, rename, rm } from "node:fs/promises";
import path from "node:path";
import { readOptions } from "./command_line.mjs";
import { withFile } from "./files.mjs";
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

const plan = await readPlan(folder);
if (plan === undefined) throw new Error(`${folder} has no run: submit.mjs or build.mjs begins one`);
const { kind, run, common, jobs } = plan;
const bad = new Set();
const kMostNamed = 20;

/** Sections of all parts in order, of some names or all; bad ones are left out, and counted. */
async function* parts(names) {
  for (let index = 0; index < jobs.length; ++index) {
    try {
      yield await readPart(folder, run, index, names);
    } catch (error) {
      if (!(error instanceof BadPart)) throw error;
      bad.add(index);
      await removePart(folder, run, index);
    }
  }
}

const strange = (await listParts(folder, run)).filter((index) => index >= jobs.length);
if (strange.length > 0) throw new Error(`parts that are not of this run: ${strange.join(", ")}`);

const { join } = kind === "tile" ? tiles : formats[common.format];
const drafts = `${out}.draft`; // a folder; whatever happens, it goes
await rm(drafts, { recursive: true, force: true });
await mkdir(drafts);
try {
  const files = await join(path.join(drafts, "result"), parts, common);
  if (bad.size > 0) {
    const some = [...bad].slice(0, kMostNamed).join(", ") + (bad.size > kMostNamed ? ", …" : "");
    throw new Error(`Missing or damaged: ${bad.size} of ${jobs.length} parts (${some})`);
  }
  for (const file of files) await withFile(file, "r", (written) => written.sync());
  await removeDrafts(folder, run);
  for (const file of files) {
    const target = out + path.basename(file).slice("result".length);
    await rename(file, target);
    console.log(target);
  }
} finally {
  await rm(drafts, { recursive: true, force: true });
}
