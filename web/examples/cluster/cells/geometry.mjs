// A cell's polygons as GeoJSON has them.

/** A polygon, or a multipolygon if there are several. */
export function geometryOf(polygons) {
  const coordinates = polygons.map((rings) => rings.map(pointsOf));
  return coordinates.length === 1
    ? { type: "Polygon", coordinates: coordinates[0] }
    : { type: "MultiPolygon", coordinates };
}

function pointsOf(ring) {
  const points = [];
  for (let k = 0; k < ring.length; k += 2) points.push([ring[k], ring[k + 1]]);
  return points;
}
