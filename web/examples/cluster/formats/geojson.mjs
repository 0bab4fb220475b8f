// GeoJSON, a feature a line: points come in, with other columns from their properties; id and
// distance go out as CSV, a line a feature. unpack.mjs makes such a file of a FeatureCollection.
import { splitLines, textOf } from "./lines.mjs";

export { encode, join } from "./csv.mjs";

export const unit = "MB";
const kTypicalLine = 128; // bytes, to guess how many lines a job gets

/** Ranges of whole lines for jobs of about this many points. */
export async function split(file, { perJob, columns }) {
  const ranges = await splitLines(file, { bytes: kTypicalLine * perJob });
  // x and y are the coordinates, whatever the columns are called
  return ranges.map((range) => ({ ...range, properties: columns.slice(2) }));
}

/** The coordinates and properties of a range, row after row. */
export async function read(file, { from, to, properties }) {
  const values = [];
  for (const [row, line] of (await textOf(file, { from, to })).split("\n").entries()) {
    const text = line.replace("\x1e", "").trim(); // RFC 8142 begins records with that character
    if (text === "") continue;
    const refuse = (problem) => {
      throw new Error(
        `${file}, after byte ${from}, line ${row}: ${problem}: ${text.slice(0, 200)}`,
      );
    };
    const feature = parsed(text);
    if (feature === undefined) refuse("no JSON");
    const { type, coordinates } = feature?.geometry ?? {};
    if (type !== "Point") refuse("no feature with a point");
    for (const k of [0, 1])
      values.push(Number.isFinite(coordinates?.[k]) ? coordinates[k] : refuse("no coordinates"));
    for (const name of properties) {
      const value = feature.properties?.[name];
      values.push(Number.isFinite(value) ? value : refuse(`no number in property ${name}`));
    }
  }
  return Float64Array.from(values);
}

function parsed(text) {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}
