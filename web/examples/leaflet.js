// Leaflet: places with their weights on a map, and who is nearest where. Degrees are no distances:
// project first (here as the map does, at one zoom), build the diagram there, and take the shapes
// back.
import { Diagram } from "apollonius-diagram";
import L from "leaflet";

const zoom = 8; // any: the unit of the diagram is a pixel of this zoom

export default function cellsOnMap(container, places) {
  const map = L.map(container, { attributionControl: false });
  map.fitBounds(L.latLngBounds(places.map(({ lat, lon }) => [lat, lon])).pad(0.3));

  const points = places.map(({ lat, lon }) => map.project([lat, lon], zoom));
  const diagram = Diagram.from(
    places,
    (_, i) => points[i].x,
    (_, i) => points[i].y,
    (d) => d.weight,
  );
  const box = map.getBounds().pad(1);
  const { x: xmin, y: ymin } = map.project(box.getNorthWest(), zoom);
  const { x: xmax, y: ymax } = map.project(box.getSouthEast(), zoom);

  const cells = L.layerGroup().addTo(map);
  const polygons = new Map();
  for (const ring of diagram.voronoi([xmin, ymin, xmax, ymax]).cellPolygons({ tolerance: 0.5 })) {
    const corners = ring.map((corner) => map.unproject(corner, zoom));
    polygons.set(ring.index, L.polygon(corners, { weight: 1, fillOpacity: 0.1 }).addTo(cells));
  }
  map.on("mousemove", ({ latlng }) => {
    const { x, y } = map.project(latlng, zoom);
    const nearest = diagram.find(x, y);
    for (const [id, polygon] of polygons)
      polygon.setStyle({ fillOpacity: id === nearest ? 0.4 : 0.1 });
  });
  map.on("unload", () => diagram.dispose());
  return { map, diagram, polygons };
}
