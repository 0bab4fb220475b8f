// Parts: what a job leaves in the work folder, one file each. A line of JSON says which job of
// which run it is, how long its sections are, and the SHA-256 of all that; then come the
// sections. A part is written beside its place and moved there, so it is whole or not there, and
// whoever does a job twice writes the same bytes.
import { createHash, randomUUID } from "node:crypto";
import { mkdir, open, readdir, readFile, rename, rm } from "node:fs/promises";
import path from "node:path";

const kLongestHeader = 4096;

const folderOf = (folder) => path.join(folder, "parts");
const nameOf = (index) => `${String(index).padStart(9, "0")}.part`;
export const partFile = (folder, index) => path.join(folderOf(folder), nameOf(index));

/** A part that is missing, or is not what its job wrote. */
export class BadPart extends Error {}

/** The sum of all that a part says and holds. */
function digest({ run, index, sections }, bytes) {
  const hash = createHash("sha256").update(JSON.stringify({ run, index, sections }));
  for (const section of bytes) hash.update(section);
  return hash.digest("hex");
}

/** Writes the part of a job; `sections` are names with bytes, in the order in which they go out. */
export async function writePart(folder, run, index, sections) {
  const bytes = Object.values(sections);
  const lengths = Object.entries(sections).map(([name, section]) => [name, section.byteLength]);
  const facts = { run, index, sections: Object.fromEntries(lengths) };
  const header = JSON.stringify({ ...facts, sha256: digest(facts, bytes) });
  await mkdir(folderOf(folder), { recursive: true });
  const draft = `${partFile(folder, index)}.${randomUUID()}`;
  const file = await open(draft, "w");
  try {
    // Not synced: what a power cut takes away, the header's lengths and sum tell.
    for (const piece of [Buffer.from(`${header}\n`), ...bytes]) await file.writeFile(piece);
  } finally {
    await file.close();
  }
  await rename(draft, partFile(folder, index));
}

/** The header, its length and the file's; null if that is no part of this job of this run. */
async function header(folder, run, index) {
  let file;
  try {
    file = await open(partFile(folder, index));
    const { buffer, bytesRead } = await file.read(Buffer.alloc(kLongestHeader), 0, kLongestHeader);
    const end = buffer.subarray(0, bytesRead).indexOf("\n");
    const found = JSON.parse(buffer.toString("utf8", 0, Math.max(0, end)));
    const length = Object.values(found.sections).reduce((sum, bytes) => sum + bytes, end + 1);
    const isWhole = (await file.stat()).size === length;
    return found.run === run && found.index === index && isWhole ? { ...found, end } : null;
  } catch (error) {
    if (error instanceof SyntaxError || error instanceof TypeError || error.code === "ENOENT")
      return null;
    throw error;
  } finally {
    await file?.close();
  }
}

/** Whether the part of a job is there, and as long as it says; its bytes are not looked at. */
export async function hasPart(folder, run, index) {
  return (await header(folder, run, index)) !== null;
}

/** The sections of a part. Throws BadPart if it is missing, or any of its bytes has changed. */
export async function readPart(folder, run, index) {
  const found = await header(folder, run, index);
  if (found === null) throw new BadPart(`part ${index} is missing or damaged`);
  const bytes = await readFile(partFile(folder, index));
  let at = found.end + 1;
  const sections = {};
  for (const [name, length] of Object.entries(found.sections)) {
    sections[name] = bytes.subarray(at, at + length);
    at += length;
  }
  if (digest(found, Object.values(sections)) !== found.sha256)
    throw new BadPart(`part ${index} is damaged`);
  return sections;
}

export async function removePart(folder, index) {
  await rm(partFile(folder, index), { force: true });
}

/** Removes what workers that died had begun to write. */
export async function removeDrafts(folder) {
  const names = await readdir(folderOf(folder)).catch(() => []);
  for (const name of names)
    if (!name.endsWith(".part")) await rm(path.join(folderOf(folder), name), { force: true });
}

/** The jobs that have left a part, whatever it is worth. */
export async function listParts(folder) {
  const names = await readdir(folderOf(folder)).catch(() => []);
  return names.filter((name) => name.endsWith(".part")).map((name) => Number.parseInt(name, 10));
}
