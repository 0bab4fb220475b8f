// From the Equal Earth map of the cities back to the Earth: places in degrees and kilometres along
// great circles, which no flat map has everywhere.
import type { Position, Projection } from "apollonius-diagram";
import { geoDistance, geoEqualEarthRaw } from "d3-geo";

const kEarthRadius = 6371; // km, as in data/make-data.mjs
const kDegree = Math.PI / 180;
const kHighest = geoEqualEarthRaw(0, Math.PI / 2)[1] * kEarthRadius; // y of the north pole

/** [longitude, latitude] of a point of the plane; beyond the map's border none is meant. */
function inverted([x, y]: Position): Position {
  const [lambda, phi] = geoEqualEarthRaw.invert(x / kEarthRadius, y / kEarthRadius);
  return [lambda / kDegree, phi / kDegree];
}

/** The map of data/cities.json: km, y to the north. */
export const equalEarth: Projection = Object.assign(
  ([lon, lat]: Position): Position => {
    const [x, y] = geoEqualEarthRaw(lon * kDegree, lat * kDegree);
    return [x * kEarthRadius, y * kEarthRadius];
  },
  {
    /** The border is the meridian of 180°, beyond which rounding must not lead. */
    invert(point: Position): Position | null {
      const [lon, lat] = inverted(point);
      return [Math.max(-180, Math.min(180, lon)), lat];
    },
  },
);

/** Where on the Earth a point of the map is; null beyond the map's border. */
export function placeOn(x: number, y: number): Position | null {
  if (Math.abs(y) > kHighest) return null;
  const place = inverted([x, y]);
  return Math.abs(place[0]) <= 180 ? place : null;
}

const kilometres = (a: Position, b: Position) => geoDistance(a, b) * kEarthRadius;

/** As "52.5° N, 13.4° E". */
export function placeText([lon, lat]: Position) {
  const text = (value: number, signs: string) =>
    `${Math.abs(value).toFixed(1)}° ${signs[value < 0 ? 1 : 0]}`;
  return `${text(lat, "NS")}, ${text(lon, "EW")}`;
}

/** As much of a set of circles as distances take: x, y, r by id. */
type Circles = {
  readonly ids: Iterable<number>;
  readonly xyr: Float64Array;
  radius(id: number): number;
};
export type Away = { id: number; distance: number };

/** True distances from and between the circles of a map. */
export class Globe {
  /** By id: where it was when it was asked for, and that place. */
  #places: { x: number; y: number; place: Position | null }[] = [];

  placeOf({ xyr }: Circles, id: number) {
    const [x, y] = [xyr[3 * id], xyr[3 * id + 1]];
    const known = this.#places[id];
    if (known?.x === x && known.y === y) return known.place;
    const place = placeOn(x, y);
    this.#places[id] = { x, y, place };
    return place;
  }

  /** km from a place to a circle's rim, as far as radii count; negative inside of it. */
  distance(circles: Circles, id: number, from: Position) {
    const place = this.placeOf(circles, id);
    return place && kilometres(from, place) - circles.radius(id);
  }

  /** The circle whose rim is nearest to a place. */
  nearest(circles: Circles, from: Position) {
    return this.#least(circles, (id) => this.distance(circles, id, from));
  }

  /** The circle whose centre is nearest to that of another one. */
  nearestCentre(circles: Circles, id: number) {
    const from = this.placeOf(circles, id);
    if (!from) return null;
    return this.#least(circles, (other) => {
      const place = other === id ? null : this.placeOf(circles, other);
      return place && kilometres(from, place);
    });
  }

  #least(circles: Circles, distance: (id: number) => number | null) {
    let least: Away | null = null;
    for (const id of circles.ids) {
      const away = distance(id);
      if (away !== null && (!least || away < least.distance)) least = { id, distance: away };
    }
    return least;
  }
}
