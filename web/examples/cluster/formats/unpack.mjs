// Files that cannot be read from the middle, compressed ones and FeatureCollections of GeoJSON: one
// pass makes a copy that can be, so that jobs read only their own ranges of it. The copy takes as
// much room as the unpacked text; the memory does not depend on its size.
import { existsSync } from "node:fs";
import { mkdir } from "node:fs/promises";
import path from "node:path";
import { Readable } from "node:stream";
import { pipeline } from "node:stream/promises";
import { createGunzip } from "node:zlib";
import { chain } from "stream-chain";
import { parser } from "stream-json";
import { pick } from "stream-json/filters/pick.js";
import { streamArray } from "stream-json/streamers/stream-array.js";
import { replaceFile, withFile } from "../files.mjs";

const kZipped = ".gz";
const kCollection = ".geojson";
const kLines = ".geojsonl";
const kPiece = 1 << 20; // bytes that are read at once

/** The end of the name of what is unpacked. */
export function extensionOf(file) {
  const extension = path.extname(file.endsWith(kZipped) ? file.slice(0, -kZipped.length) : file);
  return extension === kCollection ? kLines : extension;
}

/** A file that can be read from the middle: the same one, or its copy, at `copy` with an end. */
export async function unpacked(file, copy) {
  const isZipped = file.endsWith(kZipped);
  const isCollection = (isZipped ? file.slice(0, -kZipped.length) : file).endsWith(kCollection);
  if (!isZipped && !isCollection) return file;
  const target = copy + extensionOf(file);
  if (existsSync(target)) return target; // whole, or it would not have its name
  await mkdir(path.dirname(target), { recursive: true });
  await withFile(file, "r", (input) =>
    replaceFile(target, async (output) => {
      let refused; // a pipeline may tell of the abort that a failure has led to
      const steps = [
        Readable.from(piecesOf(input)),
        ...(isZipped ? [createGunzip()] : []),
        ...(isCollection ? [featureLines] : []),
        async (pieces) => {
          for await (const piece of pieces)
            await output.writeAll(Buffer.from(piece)).catch((error) => {
              refused = error;
              throw error;
            });
        },
      ];
      try {
        await pipeline(steps);
      } catch (error) {
        if (refused ?? error.path) throw refused ?? error; // these name their files
        throw new Error(`${file}: ${error.message}`);
      }
    }),
  );
  return target;
}

async function* piecesOf(input) {
  const size = await input.size();
  for (let at = 0; at < size; at += kPiece) yield input.readAll(Math.min(kPiece, size - at), at);
}

/** The features of a FeatureCollection, a line each. */
async function* featureLines(bytes) {
  let isThere = false;
  const seen = (token) => {
    isThere = true;
    return token;
  };
  const lines = chain([
    bytes,
    parser({ streamValues: false }),
    pick({ filter: /^features$/ }),
    seen,
    streamArray(),
    ({ value }) => `${JSON.stringify(value)}\n`,
  ]);
  yield* lines;
  if (!isThere) throw new Error("no FeatureCollection; lines of features are .geojsonl");
}
