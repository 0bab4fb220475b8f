// Parquet and GeoParquet files: columns of numbers, or points, come in; id (int32) and distance
// (float64) go out. Jobs are whole row groups.
import * as zlib from "node:zlib";
import { parquetMetadataAsync, parquetRead, parquetSchema } from "hyparquet";
import { withFile } from "../files.mjs";
import { encode as encodeBinary } from "./binary.mjs";
import { writeParquet } from "./parquet_file.mjs";

export const unit = "points";

/** Node itself can decompress these, beside what hyparquet can: zstd from Node 22.15 on. */
const compressors = {
  GZIP: (bytes) => zlib.gunzipSync(bytes),
  BROTLI: (bytes) => zlib.brotliDecompressSync(bytes),
  ...(zlib.zstdDecompressSync && { ZSTD: (bytes) => zlib.zstdDecompressSync(bytes) }),
};
const codecs = ["UNCOMPRESSED", "SNAPPY", ...Object.keys(compressors)];
const isOld = compressors.ZSTD === undefined;

async function opened(file) {
  const byteLength = await withFile(file, "r", (input) => input.size());
  const buffer = {
    byteLength,
    slice: (from, to = byteLength) =>
      withFile(file, "r", async (input) => (await input.readAll(to - from, from)).buffer),
  };
  try {
    return { buffer, metadata: await parquetMetadataAsync(buffer) };
  } catch (error) {
    if (error.path) throw error; // the system's errors name their files
    throw new Error(`${file}: ${error.message}`);
  }
}

/** The column with the points of a GeoParquet file, if it has one. */
function pointsOf(metadata) {
  const geo = metadata.key_value_metadata?.find(({ key }) => key === "geo")?.value;
  if (geo) return JSON.parse(geo).primary_column;
  const { children } = parquetSchema(metadata);
  return children.find(({ element }) => element.logical_type?.type === "GEOMETRY")?.element.name;
}

/** The columns to read: x and y by their names, or the points where there are no such columns. */
function columnsOf(file, metadata, columns) {
  const { children } = parquetSchema(metadata);
  const all = children.map(({ element }) => element.name);
  const hasBoth = columns.slice(0, 2).every((name) => all.includes(name));
  const points = hasBoth ? undefined : pointsOf(metadata);
  const names = points === undefined ? columns : [points, ...columns.slice(2)];
  for (const name of names) {
    if (!all.includes(name))
      throw new Error(`${file} has no column ${name} among ${all.join(", ")}: see --columns`);
    for (const { columns: chunks } of metadata.row_groups) {
      const { codec } = chunks.find(
        ({ meta_data }) => meta_data.path_in_schema[0] === name,
      ).meta_data;
      if (!codecs.includes(codec))
        throw new Error(
          `${file}: column ${name} is compressed by ${codec}, not ${codecs.join(", ")}` +
            (codec === "ZSTD" && isOld
              ? `; ZSTD needs Node 22.15, this is ${process.version}`
              : ""),
        );
    }
  }
  return { names, points };
}

/** Runs of row groups with `perJob` points or a few more, as a row group is not divided. */
export async function split(file, { perJob, columns }) {
  const { metadata } = await opened(file);
  const { names, points } = columnsOf(file, metadata, columns);
  const ranges = [];
  let from = 0,
    to = 0;
  const close = () => {
    if (to > from) ranges.push({ from, to, names, points, size: to - from });
    from = to;
  };
  for (const { num_rows } of metadata.row_groups) {
    to += Number(num_rows);
    if (to - from >= perJob) close();
  }
  close();
  return ranges;
}

/** The coordinates of a point as GeoParquet's encodings "WKB" and "point" have them. */
function coordinatesOf(value) {
  if (value?.type === "Point") return value.coordinates;
  return value && typeof value.x === "number" ? [value.x, value.y] : [];
}

const isNumeric = (value) =>
  typeof value === "bigint" || (typeof value === "number" && Number.isFinite(value));

/** The columns of a range, row after row. */
export async function read(file, { from, to, names, points }) {
  const { buffer, metadata } = await opened(file);
  const width = names.length + (points === undefined ? 0 : 1);
  const values = new Float64Array(width * (to - from));
  let problem; // what is thrown in `onChunk` would be lost
  const refuse = (row, name, what) =>
    (problem ??= `${file}, row ${row}: no ${what} in column ${name}`);
  const onChunk = ({ columnName: name, columnData, rowStart }) => {
    let at = width * (rowStart - from) + width - names.length + names.indexOf(name);
    for (let k = 0; k < columnData.length; ++k, at += width) {
      const value = columnData[k];
      if (name !== points) {
        if (!isNumeric(value)) return refuse(rowStart + k, name, "number");
        values[at] = Number(value);
      } else {
        const [x, y] = coordinatesOf(value);
        if (!isNumeric(x) || !isNumeric(y)) return refuse(rowStart + k, name, "point");
        values[at - 1] = x;
        values[at] = y;
      }
    }
  };
  const range = { rowStart: from, rowEnd: to, columns: names };
  try {
    await parquetRead({ file: buffer, metadata, compressors, ...range, onChunk });
  } catch (error) {
    if (error.path) throw error;
    throw new Error(`${file}, rows ${from} to ${to}: ${error.message}`);
  }
  if (problem) throw new Error(problem);
  return values;
}

export const encode = encodeBinary;

const bufferOf = (bytes) => bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);

/** A row group a part. */
export function join(out, parts, { distances }) {
  const columns = { id: "INT32", ...(distances && { distance: "DOUBLE" }) };
  async function* groups() {
    for await (const sections of parts()) {
      const ids = new Int32Array(bufferOf(sections["ids.i32"]));
      const group = [{ name: "id", data: ids }];
      if (distances)
        group.push({
          name: "distance",
          data: new Float64Array(bufferOf(sections["distances.f64"])),
        });
      yield group;
    }
  }
  return writeParquet(`${out}.parquet`, columns, groups());
}
