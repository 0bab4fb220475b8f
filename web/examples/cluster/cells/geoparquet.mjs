// Cells as GeoParquet 1.1: id, area, and geometry as WKB; a row group a tile.
import { geojsonToWkb } from "hyparquet-writer";
import { writeParquet } from "../formats/parquet_file.mjs";
import { geometryOf } from "./geometry.mjs";

const kHead = 20; // bytes of a cell before its WKB: id, area, length

/** A cell's id and area, the length of its WKB, and the WKB. */
export function encode({ id, area, polygons }) {
  const wkb = geojsonToWkb(geometryOf(polygons));
  const bytes = Buffer.alloc(kHead + wkb.length);
  bytes.writeBigInt64LE(BigInt(id), 0);
  bytes.writeDoubleLE(area, 8);
  bytes.writeUInt32LE(wkb.length, 16);
  bytes.set(wkb, kHead);
  return bytes;
}

/** The columns of the cells in a section. */
function columnsOf(bytes) {
  const [ids, areas, geometries] = [[], [], []];
  for (let at = 0; at < bytes.length; ) {
    ids.push(bytes.readBigInt64LE(at));
    areas.push(bytes.readDoubleLE(at + 8));
    const begin = at + kHead;
    at = begin + bytes.readUInt32LE(at + 16);
    geometries.push(bytes.subarray(begin, at));
  }
  return [
    { name: "id", data: BigInt64Array.from(ids) },
    { name: "area", data: Float64Array.from(areas) },
    // (of WKB, statistics say nothing)
    { name: "geometry", data: geometries, encoding: "PLAIN", statistics: false },
  ];
}

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

export function join(out, parts, common) {
  async function* groups() {
    for await (const { geoparquet } of parts(["geoparquet"])) yield columnsOf(geoparquet);
  }
  const columns = { id: "INT64", area: "DOUBLE", geometry: "BYTE_ARRAY" };
  const kvMetadata = [{ key: "geo", value: JSON.stringify(metadata(common)) }];
  return writeParquet(`${out}.parquet`, columns, groups(), { kvMetadata });
}
