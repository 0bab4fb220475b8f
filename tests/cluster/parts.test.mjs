// Parts are whole, of their job and run, and unchanged, or they are not taken.
import { readdirSync, readFileSync, truncateSync, writeFileSync } from "node:fs";
import path from "node:path";
import { beforeEach, expect, test } from "@jest/globals";
import {
  BadPart,
  hasPart,
  listParts,
  partFile,
  readPart,
  removeDrafts,
  removePart,
  writePart,
} from "../../web/examples/cluster/parts.mjs";
import { emptyFolder } from "./support/files.mjs";

const sections = { ids: Uint8Array.of(1, 2, 3, 4), distances: new Uint8Array(8).fill(9) };
let folder;

beforeEach(async () => {
  folder = emptyFolder("parts");
  await writePart(folder, "run", 5, sections);
});

test("what is written is read", async () => {
  const found = await readPart(folder, "run", 5);
  expect(Object.keys(found)).toEqual(["ids", "distances"]);
  expect([...found.ids]).toEqual([1, 2, 3, 4]);
  expect([...found.distances]).toEqual(Array(8).fill(9));
  expect(await listParts(folder, "run")).toEqual([5]);
});

test("doing a job twice gives the same file", async () => {
  const before = readFileSync(partFile(folder, "run", 5));
  await writePart(folder, "run", 5, sections);
  expect(readFileSync(partFile(folder, "run", 5)).equals(before)).toBe(true);
});

test("what a worker had only begun to write is no part, and can be removed", async () => {
  writeFileSync(`${partFile(folder, "run", 6)}.draft`, "{");
  expect(await listParts(folder, "run")).toEqual([5]);
  await removeDrafts(folder, "run");
  expect(readdirSync(path.dirname(partFile(folder, "run", 5)))).toHaveLength(1);
});

test("every changed byte is noticed, in the header and in the sections", async () => {
  const whole = readFileSync(partFile(folder, "run", 5));
  for (let k = 0; k < whole.length; ++k) {
    const bytes = Buffer.from(whole);
    bytes[k] ^= 1 << (k % 8);
    writeFileSync(partFile(folder, "run", 5), bytes);
    await expect(readPart(folder, "run", 5)).rejects.toThrow(BadPart);
  }
});

test("a part that is cut short or longer, of another run or job is none", async () => {
  expect(await hasPart(folder, "run", 5)).toBe(true);
  expect(await hasPart(folder, "other", 5)).toBe(false);
  const bytes = readFileSync(partFile(folder, "run", 5));
  writeFileSync(partFile(folder, "run", 6), bytes); // in another's place
  expect(await hasPart(folder, "run", 6)).toBe(false);
  for (const length of [0, 10, bytes.length - 1]) {
    truncateSync(partFile(folder, "run", 5), length);
    expect(await hasPart(folder, "run", 5)).toBe(false);
    writeFileSync(partFile(folder, "run", 5), bytes);
  }
  writeFileSync(partFile(folder, "run", 5), Buffer.concat([bytes, Buffer.of(0)]));
  expect(await hasPart(folder, "run", 5)).toBe(false);
  await removePart(folder, "run", 5);
  await expect(readPart(folder, "run", 5)).rejects.toThrow(BadPart);
  expect(await hasPart(folder, "run", 5)).toBe(false);
});
