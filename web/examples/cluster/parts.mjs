// Parts: what a job leaves in the work folder, one file each. A line of JSON says which job of
// which run it is, the length and SHA-256 of each section, and the SHA-256 of all that; then come
// the sections. A part is moved into place when it is whole, so it is whole or not there, and
// whoever does a job twice writes the same bytes. Each run has a folder of its own: who still works
// for another one writes to another place.
import { createHash } from "node:crypto";
import { mkdir, readdir, rm } from "node:fs/promises";
import path from "node:path";
import { replaceFile, withFile } from "./files.mjs";

const kLongestHeader = 1 << 16;

const folderOf = (folder, run) => path.join(folder, `parts-${run}`);
const nameOf = (index) => `${String(index).padStart(9, "0")}.part`;
export const partFile = (folder, run, index) => path.join(folderOf(folder, run), nameOf(index));

/** A part that is missing, or is not what its job wrote. */
export class BadPart extends Error {}

const sha256 = (bytes) => createHash("sha256").update(bytes).digest("hex");

/** The sum of what a part says about itself. */
const sumOf = ({ run, index, sections }) => sha256(JSON.stringify({ run, index, sections }));

/** Writes the part of a job; `sections` are names with bytes, in the order in which they go out. */
export async function writePart(folder, run, index, sections) {
  const facts = { run, index, sections: {} };
  for (const [name, bytes] of Object.entries(sections))
    facts.sections[name] = { length: bytes.byteLength, sha256: sha256(bytes) };
  const header = JSON.stringify({ ...facts, sha256: sumOf(facts) });
  await mkdir(folderOf(folder, run), { recursive: true });
  await replaceFile(partFile(folder, run, index), async (file) => {
    // Not synced: what a power cut takes away, lengths and sums tell.
    for (const piece of [Buffer.from(`${header}\n`), ...Object.values(sections)])
      await file.writeAll(piece);
  });
}

/** The sections of a part that is open, with their places; null if it is not that of the job. */
async function sectionsOf(file, run, index) {
  const size = await file.size();
  const head = await file.readAll(Math.min(size, kLongestHeader), 0);
  const end = Math.max(0, head.indexOf("\n"));
  let facts;
  try {
    facts = JSON.parse(head.toString("utf8", 0, end));
    if (sumOf(facts) !== facts.sha256) return null;
  } catch {
    return null;
  }
  let at = end + 1;
  for (const section of Object.values(facts.sections)) {
    section.at = at;
    at += section.length;
  }
  return facts.run === run && facts.index === index && at === size ? facts.sections : null;
}

/** Opens a part and calls action(file, sections); null without a good part. */
async function withPart(folder, run, index, action) {
  try {
    return await withFile(partFile(folder, run, index), "r", async (file) => {
      const sections = await sectionsOf(file, run, index);
      return sections && (await action(file, sections));
    });
  } catch (error) {
    if (error.code === "ENOENT") return null;
    throw error;
  }
}

/** Whether the part of a job is there, and as long as it says; its sections are not looked at. */
export async function hasPart(folder, run, index) {
  return (await withPart(folder, run, index, () => true)) !== null;
}

/**
 * Sections of a part: those of some names, or all; no others are read. Throws BadPart if one is
 * missing, or any of its bytes has changed.
 */
export async function readPart(folder, run, index, names) {
  const found = await withPart(folder, run, index, async (file, sections) => {
    const wanted = {};
    for (const name of names ?? Object.keys(sections)) {
      const { at, length, sha256: expected } = sections[name] ?? {};
      if (expected === undefined) return null;
      wanted[name] = await file.readAll(length, at);
      if (sha256(wanted[name]) !== expected) return null;
    }
    return wanted;
  });
  if (found === null) throw new BadPart(`part ${index} is missing or damaged`);
  return found;
}

export async function removePart(folder, run, index) {
  await rm(partFile(folder, run, index), { force: true });
}

const namesIn = (folder, run) => readdir(folderOf(folder, run)).catch(() => []);

/** Removes what workers that died had begun to write. */
export async function removeDrafts(folder, run) {
  for (const name of await namesIn(folder, run))
    if (!name.endsWith(".part")) await rm(path.join(folderOf(folder, run), name), { force: true });
}

/** The jobs that have left a part, whatever it is worth. */
export async function listParts(folder, run) {
  const names = (await namesIn(folder, run)).filter((name) => name.endsWith(".part"));
  return names.map((name) => Number.parseInt(name, 10));
}
