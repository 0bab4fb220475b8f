// Arrow IPC files: columns of numbers come in, id (int32) and distance (float64) go out. Jobs are
// whole record batches, which a file lets one read by their numbers.
import { Readable } from "node:stream";
import { pipeline } from "node:stream/promises";
import {
  DataType,
  Field,
  Float64,
  Int32,
  makeData,
  Precision,
  RecordBatch,
  RecordBatchFileWriter,
  RecordBatchReader,
  Schema,
  Struct,
  Table,
  tableFromIPC,
  tableToIPC,
} from "apache-arrow";
import { withFile } from "../files.mjs";

export const unit = "points";

const isNumeric = (type) =>
  DataType.isInt(type) || (DataType.isFloat(type) && type.precision !== Precision.HALF);

/** A file as the library takes it: whatever it asks for is read to the last byte, or it throws. */
async function sourceOf(input) {
  const size = await input.size();
  return {
    fd: 0, // by a number here the library tells that this is a file
    stat: async () => ({ size }),
    close: async () => {},
    async read(buffer, offset, length, position) {
      buffer.set(await input.readAll(length, position), offset);
      return { bytesRead: length, buffer };
    },
  };
}

function withReader(file, action) {
  return withFile(file, "r", async (input) => {
    try {
      const reader = await RecordBatchReader.from(await sourceOf(input));
      if (!reader.isFile())
        throw new Error("no Arrow IPC file (a stream has no places to read at)");
      return await action(await reader.open());
    } catch (error) {
      if (!error.message.includes(file)) error.message = `${file}: ${error.message}`;
      throw error;
    }
  });
}

/** Runs of record batches of about `perJob` points, as many as the first batch promises. */
export function split(file, { perJob, columns }) {
  return withReader(file, async (reader) => {
    const count = reader.numRecordBatches;
    const inBatch = count > 0 ? (await reader.readRecordBatch(0)).numRows : 0;
    const together = Math.max(1, Math.round(perJob / Math.max(1, inBatch)));
    return Array.from({ length: Math.ceil(count / together) }, (_, k) => {
      const from = k * together;
      const to = Math.min(from + together, count);
      return { from, to, columns, size: (to - from) * inBatch };
    });
  });
}

/** The columns of some batches, row after row. */
export function read(file, { from, to, columns }) {
  return withReader(file, async (reader) => {
    const batches = [];
    for (let k = from; k < to; ++k) batches.push(await reader.readRecordBatch(k));
    const width = columns.length;
    const values = new Float64Array(width * batches.reduce((sum, { numRows }) => sum + numRows, 0));
    columns.forEach((name, place) => {
      let at = place;
      for (const batch of batches) {
        const column = batch.getChild(name);
        if (column === null) throw new Error(`${file} has no column ${name}: see --columns`);
        if (column.nullCount > 0) throw new Error(`${file}: nulls in column ${name}`);
        if (!isNumeric(column.type)) throw new Error(`${file}: column ${name} is ${column.type}`);
        for (const value of column.toArray()) {
          values[at] = Number(value);
          at += width;
        }
      }
    });
    return values;
  });
}

const field = (name, type) => Field.new({ name, type, nullable: false });
const fields = [field("id", new Int32()), field("distance", new Float64())];

/** One batch. With its schema, as the library would guess another one for no rows. */
export function encode(ids, distances) {
  const columns = distances ? [ids, distances] : [ids];
  const type = new Struct(fields.slice(0, columns.length));
  const children = columns.map((data, k) => makeData({ type: fields[k].type, data, nullCount: 0 }));
  const rows = makeData({ type, length: ids.length, nullCount: 0, children });
  const batch = new RecordBatch(new Schema(type.children), rows);
  return { arrow: tableToIPC(new Table([batch]), "file") };
}

export async function join(out, parts) {
  async function* batches() {
    for await (const { arrow } of parts()) yield* tableFromIPC(arrow).batches;
  }
  const file = `${out}.arrow`;
  const writer = RecordBatchFileWriter.throughNode();
  await withFile(file, "w", (output) =>
    pipeline(Readable.from(batches()), writer, async (pieces) => {
      for await (const piece of pieces) await output.writeAll(piece);
    }),
  );
  return [file];
}
