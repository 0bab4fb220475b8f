// Cells as GeoParquet 1.1: id, area, and geometry as WKB; a row group a tile.
import { fileWriter, geojsonToWkb, ParquetWriter } from "hyparquet-writer";
import { geometryOf } from "./geometry.mjs";

/** The length of a cell's WKB, and the WKB. Its id and area are in the areas of the part. */
export function encode({ polygons }) {
  const wkb = geojsonToWkb(geometryOf(polygons));
  const bytes = Buffer.alloc(4 + wkb.length);
  bytes.writeUInt32LE(wkb.length);
  bytes.set(wkb, 4);
  return bytes;
}

function* geometriesOf(bytes) {
  for (let at = 0; at < bytes.length; ) {
    const end = at + 4 + bytes.readUInt32LE(at);
    yield bytes.subarray(at + 4, end);
    at = end;
  }
}

const column = (name, type) => ({ name, type, repetition_type: "REQUIRED" });
const columns = [column("id", "INT64"), column("area", "DOUBLE"), column("geometry", "BYTE_ARRAY")];
const schema = [{ name: "root", num_children: columns.length }, ...columns];

/** Without a crs, readers take longitude and latitude; null says that it is not known. */
function metadata({ window: bbox, isLonLat }) {
  const geometry = {
    encoding: "WKB",
    geometry_types: ["Polygon", "MultiPolygon"],
    ...(!isLonLat && { crs: null }),
    bbox, // cells fill the window
  };
  return { version: "1.1.0", primary_column: "geometry", columns: { geometry } };
}

export async function join(out, parts, common) {
  const file = `${out}.parquet`;
  const kvMetadata = [{ key: "geo", value: JSON.stringify(metadata(common)) }];
  const writer = new ParquetWriter({ writer: fileWriter(file), schema, kvMetadata });
  for await (const { areas, geoparquet } of parts()) {
    const count = areas.length / 16;
    const ids = BigInt64Array.from({ length: count }, (_, k) => BigInt(areas.readDoubleLE(16 * k)));
    const columnData = [
      { name: "id", data: ids },
      {
        name: "area",
        data: Float64Array.from({ length: count }, (_, k) => areas.readDoubleLE(16 * k + 8)),
      },
      {
        name: "geometry",
        data: [...geometriesOf(geoparquet)],
        encoding: "PLAIN",
        statistics: false, // of WKB they say nothing
      },
    ];
    await writer.write({ columnData, rowGroupSize: Math.max(1, count) });
  }
  await writer.finish();
  return [file];
}
