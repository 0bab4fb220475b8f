// Snapshots as files. Where there are only circles it is the package's own (docs/SNAPSHOTS.md). The
// package knows no names and no maps; so with these it is a ZIP archive: diagram.bin, the package's
// snapshot, which Diagram.fromBytes reads; names.json, an array of { id, name, detail }; map.json.
import { strFromU8, strToU8, unzipSync, zipSync } from "fflate";
import type { Sites } from "../model/sites.js";
import { onEarthIn, onEarthOf } from "./earth.js";

export type Named = { id: number; name: string; detail?: string };

const kDiagram = "diagram.bin";
const kNames = "names.json";
const kMap = "map.json";
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
  const names = Array.from(sites.labels, ([id, label]): Named => ({ id, ...label }));
  const onEarth = onEarthOf(sites.info);
  if (names.length === 0 && !onEarth) return { bytes: snapshot, extension: "bin" };
  const json = (data: unknown) => strToU8(JSON.stringify(data, null, 1));
  const files = { [kDiagram]: snapshot, [kNames]: json(names) };
  const all = onEarth ? { ...files, [kMap]: json(onEarth) } : files;
  return { bytes: zipSync(all), extension: "zip" };
}

/** What is in an archive of `snapshotOf`. */
export function unpacked(bytes: Uint8Array) {
  const files = unzipSync(bytes, {
    filter: ({ name, originalSize }) => {
      if (originalSize > kMostBytes) throw new Error(`${name} in this archive is too large`);
      return [kDiagram, kNames, kMap].includes(name);
    },
  });
  const { [kDiagram]: snapshot, [kNames]: names, [kMap]: map } = files;
  if (!snapshot) throw new Error(`there is no ${kDiagram} in this archive`);
  const json = (file: Uint8Array): unknown => JSON.parse(strFromU8(file));
  return {
    snapshot,
    names: names ? namesIn(json(names)) : [],
    onEarth: map ? onEarthIn(json(map)) : null,
  };
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
