// Cells as GeoJSON, a feature a line.
import { joinSections } from "../formats/join.mjs";
import { geometryOf } from "./geometry.mjs";

export function encode({ id, area, polygons }) {
  const geometry = geometryOf(polygons);
  const feature = { type: "Feature", id, properties: { area }, geometry };
  return Buffer.from(`${JSON.stringify(feature)}\n`);
}

export function join(out, parts) {
  async function* features() {
    for await (const { geojson } of parts(["geojson"])) yield { geojsonl: geojson };
  }
  return joinSections(out, features);
}
