// Files that cannot be read from the middle, compressed ones and FeatureCollections of GeoJSON: one
// pass makes a copy that can be, so that jobs read only their own ranges of it. The copy takes as
// much room as the unpacked text; the memory does not depend on its size.
import { createReadStream, createWriteStream, existsSync } from "node:fs";
import { mkdir, rename } from "node:fs/promises";
import path from "node:path";
import { pipeline } from "node:stream/promises";
import { createGunzip } from "node:zlib";
import { chain } from "stream-chain";
import { parser } from "stream-json";
import { pick } from "stream-json/filters/pick.js";
import { streamArray } from "stream-json/streamers/stream-array.js";

const kZipped = ".gz";
const kCollection = ".geojson";
const kLines = ".geojsonl";

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
  const steps = [
    createReadStream(file),
    ...(isZipped ? [createGunzip()] : []),
    ...(isCollection ? [featureLines] : []),
    createWriteStream(`${target}.new`),
  ];
  try {
    await pipeline(steps);
  } catch (error) {
    if (error.path) throw error; // the system's errors name their files
    throw new Error(`${file}: ${error.message}`);
  }
  await rename(`${target}.new`, target);
  return target;
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
