// MapLibre GL: places with a head start each, and from which one every point is reached first, in
// true kilometres: the diagram is on the sphere, so that nothing is to be projected. Its GeoJSON is
// a source for the map, and whose cell the pointer is in, the diagram says. (The page needs
// maplibre-gl.css; bundlers may need MapLibre's setWorkerUrl.)
import { SphericalDiagram } from "apollonius-diagram/sphere";
import { LngLatBounds, Map as MapLibreMap } from "maplibre-gl";

/** @returns {any} */
const lit = (yes, no) => ["case", ["boolean", ["feature-state", "lit"], false], yes, no];

/**
 * Resolves once the cells are on the map. Places are {lon, lat, reach}, reach in km; style is a
 * map's, by default an empty one.
 */
export default async function cellsOnMap(container, places, { style = kEmpty } = {}) {
  const diagram = SphericalDiagram.from(
    places,
    ({ lon }) => lon,
    ({ lat }) => lat,
    ({ reach }) => reach,
    { radius: 6371.0088 },
  );
  const bounds = new LngLatBounds();
  for (const { lon, lat } of places) bounds.extend([lon, lat]);
  const map = new MapLibreMap({
    container,
    style,
    bounds,
    fitBoundsOptions: { padding: 60 },
    attributionControl: false,
    renderWorldCopies: false,
  });
  await map.once("load");

  // The ids of the features are those of the sites, for setFeatureState.
  // The tolerance is in kilometres, as the radius.
  const cells = diagram.voronoi().toGeoJSON({ tolerance: 0.06 });
  map.addSource("cells", { type: "geojson", data: cells });
  map.addLayer({
    id: "cells",
    type: "fill",
    source: "cells",
    paint: { "fill-color": lit("#e15759", "#4e79a7"), "fill-opacity": lit(0.5, 0.15) },
  });
  map.addLayer({
    id: "borders",
    type: "line",
    source: "cells",
    paint: { "line-color": "#4e79a7", "line-width": 1.5 },
  });
  const coordinates = places.map(({ lon, lat }) => [lon, lat]);
  map.addSource("places", { type: "geojson", data: { type: "MultiPoint", coordinates } });
  map.addLayer({ id: "places", type: "circle", source: "places", paint: { "circle-radius": 3 } });

  let shown = -1;
  const light = (id) => {
    if (id === shown) return;
    if (shown >= 0) map.setFeatureState({ source: "cells", id: shown }, { lit: false });
    if (id >= 0) map.setFeatureState({ source: "cells", id }, { lit: true });
    shown = id;
  };
  map.on("mousemove", ({ lngLat }) => light(diagram.find(lngLat.lng, lngLat.lat)));
  map.on("mouseout", () => light(-1));
  map.on("remove", () => diagram.dispose());
  return { map, diagram, lit: () => shown };
}

/** @type {import("maplibre-gl").StyleSpecification} */
const kEmpty = {
  version: 8,
  sources: {},
  layers: [{ id: "paper", type: "background", paint: { "background-color": "#fafaf7" } }],
};
