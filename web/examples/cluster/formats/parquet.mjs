// Parquet and GeoParquet files: columns of numbers, or points, come in; id (int32) and distance
// (float64) go out. Jobs are whole row groups.
import * as zlib from "node:zlib";
import { asyncBufferFromFile, parquetMetadataAsync, parquetRead, parquetSchema } from "hyparquet";
import { fileWriter, ParquetWriter } from "hyparquet-writer";
import { encode as encodeBinary } from "./binary.mjs";

export const unit = "points";

/** What Node itself can decompress, beside what hyparquet can: zstd from Node 22.15 on. */
const compressors = {
  GZIP: (bytes) => zlib.gunzipSync(bytes),
  BROTLI: (bytes) => zlib.brotliDecompressSync(bytes),
  ...(zlib.zstdDecompressSync && { ZSTD: (bytes) => zlib.zstdDecompressSync(bytes) }),
};
const codecs = ["UNCOMPRESSED", "SNAPPY", ...Object.keys(compressors)];

async function opened(file) {
  const buffer = await asyncBufferFromFile(file);
  try {
    return { buffer, metadata: await parquetMetadataAsync(buffer) };
  } catch (error) {
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
          `${file}: column ${name} is compressed by ${codec}, not ${codecs.join(", ")}`,
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
    throw new Error(`${file}, rows ${from} to ${to}: ${error.message}`);
  }
  if (problem) throw new Error(problem);
  return values;
}

export const encode = encodeBinary;

const column = (name, type) => ({ name, type, repetition_type: "REQUIRED" });

/** A row group a part. */
export async function join(out, parts, { distances }) {
  const file = `${out}.parquet`;
  const columns = [column("id", "INT32"), ...(distances ? [column("distance", "DOUBLE")] : [])];
  const schema = [{ name: "root", num_children: columns.length }, ...columns];
  const writer = new ParquetWriter({ writer: fileWriter(file), schema });
  for await (const sections of parts()) {
    const copy = (bytes) => bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
    const columnData = [{ name: "id", data: new Int32Array(copy(sections["ids.i32"])) }];
    if (distances)
      columnData.push({
        name: "distance",
        data: new Float64Array(copy(sections["distances.f64"])),
      });
    await writer.write({ columnData, rowGroupSize: Math.max(1, columnData[0].data.length) });
  }
  await writer.finish();
  return [file];
}
