// Files for the tests of the cluster example: in build/cluster, a folder a test.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { root } from "../../../tools/toolchain/folders.mjs";

/** A new empty folder. */
export function emptyFolder(name) {
  const folder = path.join(root, "build/cluster", name);
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  return folder;
}

export const bytesOf = (array) => new Uint8Array(array.buffer, array.byteOffset, array.byteLength);

export function writeArray(file, array) {
  writeFileSync(file, bytesOf(array));
  return file;
}

export function readDoubles(file) {
  const bytes = readFileSync(file);
  return new Float64Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
}

/** Changes one byte of a file, at a share of its length. */
export function damage(file, share) {
  const bytes = readFileSync(file);
  bytes[Math.floor(share * (bytes.length - 1))] ^= 1;
  writeFileSync(file, bytes);
}
