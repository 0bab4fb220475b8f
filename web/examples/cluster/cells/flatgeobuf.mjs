// Cells as FlatGeobuf: a header, a tree of the cells' boxes, and the cells in the order of parts.
import * as flatbuffers from "flatbuffers";
import { Column } from "flatgeobuf/lib/mjs/flat-geobuf/column.js";
import { ColumnType } from "flatgeobuf/lib/mjs/flat-geobuf/column-type.js";
import { Crs } from "flatgeobuf/lib/mjs/flat-geobuf/crs.js";
import { GeometryType } from "flatgeobuf/lib/mjs/flat-geobuf/geometry-type.js";
import { Header } from "flatgeobuf/lib/mjs/flat-geobuf/header.js";
import { buildFeature } from "flatgeobuf/lib/mjs/generic/feature.js";
import { withFile } from "../files.mjs";
import { BoxTree, kTogether } from "./box_tree.mjs";

const kMagic = Buffer.from("fgb\x03fgb\0", "latin1");
const kBox = 32; // bytes
const kWgs84 = 4326; // of EPSG: longitude and latitude
const columns = [
  { name: "id", type: ColumnType.Long },
  { name: "area", type: ColumnType.Double },
];

/** A cell's box, for the tree, and its feature, which begins with its length. */
export function encode({ id, area, polygons }) {
  const parts = polygons.map((rings) => {
    let end = 0;
    return {
      type: GeometryType.Polygon,
      xy: rings.length === 1 ? rings[0] : rings.flatMap((ring) => [...ring]),
      ends: rings.length === 1 ? undefined : rings.map(({ length }) => (end += length / 2)),
    };
  });
  // All are multipolygons, as many programs take one type of geometry for a whole file.
  const geometry = { type: GeometryType.MultiPolygon, parts };
  const box = new Uint8Array(boxOf(polygons).buffer);
  return Buffer.concat([box, buildFeature(geometry, { id, area }, { columns })]);
}

function boxOf(polygons) {
  const box = Float64Array.of(Infinity, Infinity, -Infinity, -Infinity);
  for (const [ring] of polygons) {
    for (let k = 0; k < ring.length; ++k) {
      const axis = k % 2;
      box[axis] = Math.min(box[axis], ring[k]);
      box[axis + 2] = Math.max(box[axis + 2], ring[k]);
    }
  }
  return box;
}

function header({ window, isLonLat, features }) {
  const builder = new flatbuffers.Builder();
  const columnOffsets = columns.map(({ name, type }) => {
    const nameOffset = builder.createString(name);
    Column.startColumn(builder);
    Column.addName(builder, nameOffset);
    Column.addType(builder, type);
    return Column.endColumn(builder);
  });
  const columnsOffset = Header.createColumnsVector(builder, columnOffsets);
  const envelope = Header.createEnvelopeVector(builder, window); // cells fill it
  const name = builder.createString("cells");
  let crs = 0; // not known
  if (isLonLat) {
    Crs.startCrs(builder);
    Crs.addCode(builder, kWgs84);
    crs = Crs.endCrs(builder);
  }
  Header.startHeader(builder);
  Header.addName(builder, name);
  Header.addEnvelope(builder, envelope);
  Header.addGeometryType(builder, GeometryType.MultiPolygon);
  Header.addColumns(builder, columnsOffset);
  Header.addFeaturesCount(builder, BigInt(features));
  Header.addIndexNodeSize(builder, features > 0 ? kTogether : 0);
  if (crs !== 0) Header.addCrs(builder, crs);
  builder.finishSizePrefixed(Header.endHeader(builder));
  return Buffer.concat([kMagic, builder.asUint8Array()]);
}

/** The features of a section, one after the other; each one's box and place go into the tree. */
function taken(section, tree, first) {
  const features = Buffer.alloc(section.length);
  let length = 0;
  for (let at = 0; at < section.length; ) {
    const box = [0, 8, 16, 24].map((offset) => section.readDoubleLE(at + offset));
    tree.add(box, first + length);
    const end = at + kBox + 4 + section.readUInt32LE(at + kBox);
    length += section.copy(features, length, at + kBox, end);
    at = end;
  }
  return features.subarray(0, length);
}

export async function join(out, parts, common) {
  const file = `${out}.fgb`;
  await withFile(file, "w", async (output) => {
    const head = header(common);
    const tree = new BoxTree(common.features);
    const start = head.length + tree.bytes;
    let length = 0;
    await output.writeAll(head, 0);
    for await (const { flatgeobuf } of parts(["flatgeobuf"])) {
      const features = taken(flatgeobuf, tree, length);
      await output.writeAll(features, start + length);
      length += features.length;
      await tree.flush(output, head.length);
    }
  });
  return [file];
}
