// The cells as GeoJSON (RFC 7946). On a map of the Earth they are in longitude and latitude
// (WGS 84), and whole; in the plane, as far as they are shown, in the diagram's own coordinates.
// Circles without such a cell are points. The properties hold the circles, and on a map a member of
// the file's says which: so the file can be opened again.
import type { Position, Voronoi } from "apollonius-diagram";
import type { App } from "../app.js";
import { boundsOf, windowOf } from "../picture/curves.js";
import { type OnEarth, onEarthIn, onEarthOf } from "./earth.js";
import { equalEarth, placeOn } from "../model/globe.js";

const kTolerance = 0.25; // pixels between a polygon and the true curve
const kWorld = [-180, -90, 180, 90] as const;
const kOurs = "apollonius-diagram"; // a foreign member, as GeoJSON calls it

type Properties = {
  site: number;
  name?: string;
  detail?: string;
  x: number;
  y: number;
  r: number;
  area: number | null;
  hidden?: true;
};

export function toGeoJson(app: App) {
  const { sites, view } = app;
  const cells = cellsOf(app);
  const properties = (id: number): Properties => ({
    site: id,
    ...sites.labels.get(id),
    ...sites.site(id),
    area: sites.isHidden(id) ? null : cells.cellArea(id),
    ...(sites.isHidden(id) ? { hidden: true } : {}),
  });
  const shown = cells.toGeoJSON({ tolerance: kTolerance / view.scale, properties });
  const there = new Set(shown.features.map(({ id }) => id));
  const others = Array.from(sites.ids)
    .filter((id) => !there.has(id))
    .map((id) => ({
      type: "Feature",
      id,
      properties: properties(id),
      geometry: pointOf(app, id),
    }));
  const onEarth = onEarthOf(sites.info);
  return JSON.stringify({
    type: shown.type,
    ...(onEarth ? { [kOurs]: onEarth } : {}),
    features: [...shown.features, ...others],
  });
}

/** Reads what `toGeoJson` has written of the map, if this is a file of it. */
export const onEarthInGeoJson = (data: object): OnEarth | null =>
  onEarthIn((data as { [kOurs]?: unknown })[kOurs]);

function cellsOf({ sites, view, painter, diagram }: App): Voronoi {
  const { map, globe } = sites.info;
  if (!globe || !map) {
    if (painter.ends) return painter.ends;
    const bounds = boundsOf(view, windowOf(view));
    if (!bounds) throw new Error("this is nearer than numbers resolve: zoom out");
    return diagram.voronoi(bounds);
  }
  const window = painter.layers.coast ? map.land.rings.map(inDegrees) : kWorld;
  return diagram.voronoi(window, { project: equalEarth });
}

/** A ring x, y, … of the map as longitudes and latitudes. */
function inDegrees(ring: readonly number[]) {
  const places: Position[] = [];
  for (let k = 0; k < ring.length; k += 2) {
    const place = equalEarth.invert([ring[k], ring[k + 1]]);
    if (place) places.push(place);
  }
  return places;
}

/** null, as GeoJSON has it, for what is beyond the map. */
function pointOf({ sites }: App, id: number) {
  const { x, y } = sites.site(id);
  const coordinates = sites.info.globe ? placeOn(x, y) : [x, y];
  return coordinates && { type: "Point", coordinates };
}
