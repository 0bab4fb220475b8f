// Files of cells, read by the libraries of their formats.
import { readFileSync } from "node:fs";
import { deserialize } from "flatgeobuf/lib/mjs/geojson.js";

/** The features of a FlatGeobuf file, and its header; those that meet a rectangle, if given. */
export async function readFlatGeobuf(file, rect) {
  const features = [];
  let header;
  const headerMetaFn = (meta) => (header = meta);
  const bytes = new Uint8Array(readFileSync(file)); // a copy, as the library takes a whole buffer
  const say = console.debug;
  console.debug = () => {}; // the search tells of each node
  try {
    for await (const feature of deserialize(bytes, { rect, headerMetaFn })) features.push(feature);
  } finally {
    console.debug = say;
  }
  return { features, header };
}

export const readLines = (file) =>
  readFileSync(file, "utf8")
    .trim()
    .split("\n")
    .map((line) => JSON.parse(line));

export const polygonsOf = ({ type, coordinates }) =>
  type === "Polygon" ? [coordinates] : coordinates;

/** Does the box of a geometry meet a rectangle? */
export function meets(geometry, { minX, minY, maxX, maxY }) {
  const points = polygonsOf(geometry).flat(2);
  const [xs, ys] = [0, 1].map((axis) => points.map((point) => point[axis]));
  return (
    Math.min(...xs) <= maxX &&
    Math.max(...xs) >= minX &&
    Math.min(...ys) <= maxY &&
    Math.max(...ys) >= minY
  );
}
