// Files that cannot be read from the middle, compressed ones and FeatureCollections of GeoJSON: one
// pass makes a copy that can be, so that jobs read only their own ranges of it. The copy takes as
// much room as the unpacked text; the memory does not depend on its size.
import { createReadStream, createWriteStream, existsSync } from "node:fs";
import { mkdir, rename } from "node:fs/promises";
import path from "node:path";
import { pipeline } from "node:stream/promises";
import { createGunzip } from "node:zlib";

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

const [kQuote, kBackslash, kOpen, kClose, kOpenArray, kCloseArray, kSpace] =
  Buffer.from('"\\{}[] ');
const kLineEnd = Buffer.from("\n");

/**
 * The features of a FeatureCollection, a line each. Looks at brackets and quotes only, which are no
 * part of other characters in UTF-8; whoever reads the lines parses them.
 */
async function* featureLines(chunks) {
  let depth = 0, // how many brackets are open
    isText = false, // between quotes
    isEscaped = false, // after a backslash
    key = "", // the last text directly in the collection
    isIn = false, // in the array "features"
    found = false;
  for await (const chunk of chunks) {
    const pieces = [];
    let from = isIn && depth > 2 ? 0 : -1; // where a feature, or the rest of one, begins
    for (let k = 0; k < chunk.length; ++k) {
      const byte = chunk[k];
      if (isText) {
        if (isEscaped) isEscaped = false;
        else if (byte === kBackslash) isEscaped = true;
        else if (byte === kQuote) isText = false;
        else if (depth === 1) key += String.fromCharCode(byte);
      } else if (byte === kQuote) {
        isText = true;
        if (depth === 1) key = "";
      } else if (byte === kOpen || byte === kOpenArray) {
        if (depth === 1 && byte === kOpenArray && key === "features") isIn = found = true;
        else if (isIn && depth === 2) from = k;
        ++depth;
      } else if (byte === kClose || byte === kCloseArray) {
        --depth;
        if (depth === 1) isIn = false;
        if (!isIn || depth !== 2) continue;
        pieces.push(chunk.subarray(from, k + 1), kLineEnd);
        from = -1;
      } else if (byte < kSpace) {
        chunk[k] = kSpace; // line ends within a feature; texts have none, but \n
      }
    }
    if (from >= 0) pieces.push(chunk.subarray(from));
    if (pieces.length > 0) yield Buffer.concat(pieces);
  }
  if (depth !== 0 || isText) throw new Error("the JSON ends in the middle");
  if (!found) throw new Error("no FeatureCollection; lines of features are .geojsonl");
}
