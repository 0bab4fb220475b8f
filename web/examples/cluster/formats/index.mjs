// The format of a file, by the end of its name.
import path from "node:path";
import * as arrow from "./arrow.mjs";
import * as binary from "./binary.mjs";
import * as csv from "./csv.mjs";

export const formats = { arrow, binary, csv };
const byExtension = { ".arrow": "arrow", ".feather": "arrow", ".f64": "binary", ".csv": "csv" };

export function formatOf(file) {
  const format = byExtension[path.extname(file)];
  if (format) return format;
  throw new Error(`${file}: expected one of ${Object.keys(byExtension).join(", ")}`);
}
