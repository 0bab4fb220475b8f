// Snapshots as files. Without names it is the package's own (docs/SNAPSHOTS.md). The package knows
// no names; so with names it is a ZIP archive of two files: diagram.bin, the package's snapshot,
// which Diagram.fromBytes reads, and names.json, an array of { id, name, detail }.
import { strFromU8, strToU8, unzipSync, zipSync } from "fflate";
import type { Sites } from "../model/sites.js";

export type Named = { id: number; name: string; detail?: string };

const kDiagram = "diagram.bin";
const kNames = "names.json";
const kMostBytes = 2 ** 30; // unpacked: of 16 million circles

const startsWith = (bytes: Uint8Array, text: string) =>
  strFromU8(bytes.subarray(0, text.length), true) === text;

/** Whether these are bytes of a diagram. */
export const isSnapshot = (bytes: Uint8Array) => startsWith(bytes, "Apol");

/** Whether these are bytes of a ZIP archive. */
export const isPacked = (bytes: Uint8Array) => startsWith(bytes, "PK");

/** A file that `sitesFromFile` reads, and what its name ends with. */
export function snapshotOf(sites: Sites) {
  const snapshot = sites.toBytes();
  if (sites.labels.size === 0) return { bytes: snapshot, extension: "bin" };
  const names = Array.from(sites.labels, ([id, label]): Named => ({ id, ...label }));
  const files = { [kDiagram]: snapshot, [kNames]: strToU8(JSON.stringify(names, null, 1)) };
  return { bytes: zipSync(files), extension: "zip" };
}

/** What is in an archive of `snapshotOf`. */
export function unpacked(bytes: Uint8Array) {
  const files = unzipSync(bytes, {
    filter: ({ name, originalSize }) => {
      if (originalSize > kMostBytes) throw new Error(`${name} in this archive is too large`);
      return name === kDiagram || name === kNames;
    },
  });
  const { [kDiagram]: snapshot, [kNames]: names } = files;
  if (!snapshot) throw new Error(`there is no ${kDiagram} in this archive`);
  return { snapshot, names: names ? namesIn(JSON.parse(strFromU8(names))) : [] };
}

function namesIn(data: unknown): Named[] {
  if (!Array.isArray(data) || !data.every(isNamed))
    throw new Error(`${kNames} in this archive is no list of ids and names`);
  return data.map(({ id, name, detail }) => ({ id, name, ...(detail ? { detail } : {}) }));
}

function isNamed(item: unknown): item is Named {
  if (typeof item !== "object" || item === null) return false;
  const { id, name, detail } = item as Partial<Record<keyof Named, unknown>>;
  return (
    Number.isInteger(id) &&
    typeof name === "string" &&
    (detail === undefined || typeof detail === "string")
  );
}
