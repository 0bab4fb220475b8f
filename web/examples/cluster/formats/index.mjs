// The format of a file, by the end of its name.
import * as arrow from "./arrow.mjs";
import * as binary from "./binary.mjs";
import * as csv from "./csv.mjs";
import * as geojson from "./geojson.mjs";
import * as parquet from "./parquet.mjs";
import { extensionOf } from "./unpack.mjs";

export const formats = { arrow, binary, csv, geojson, parquet };
const byExtension = {
  ".arrow": "arrow",
  ".feather": "arrow",
  ".f64": "binary",
  ".csv": "csv",
  ".geojsonl": "geojson",
  ".parquet": "parquet",
};

/** The format of a file, or of what is unpacked of it. */
export function formatOf(file) {
  const format = byExtension[extensionOf(file)];
  if (format) return format;
  const all = [...Object.keys(byExtension), ".geojson"].join(", ");
  throw new Error(`${file}: expected one of ${all}, or one of these with .gz`);
}
