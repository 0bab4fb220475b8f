// Parquet files that are written row group by row group, each of them as soon as it is there.
import { ByteWriter, ParquetWriter } from "hyparquet-writer";
import { withFile } from "../files.mjs";

/** Writes groups, each the data of all columns; `columns` are their names with their types. */
export async function writeParquet(file, columns, groups, { kvMetadata } = {}) {
  const fields = Object.entries(columns).map(([name, type]) => ({
    name,
    type,
    repetition_type: "REQUIRED",
  }));
  const schema = [{ name: "root", num_children: fields.length }, ...fields];
  await withFile(file, "w", async (output) => {
    const bytes = new ByteWriter();
    const flush = async () => {
      await output.writeAll(bytes.getBytes());
      bytes.index = 0; // as the library's own writer of files does
    };
    const writer = new ParquetWriter({ writer: bytes, schema, kvMetadata });
    for await (const columnData of groups) {
      await writer.write({ columnData, rowGroupSize: Math.max(1, columnData[0].data.length) });
      await flush();
    }
    await writer.finish();
    await flush();
  });
  return [file];
}
