// Empty circles on the sphere: the places that are farthest from all sites.
//
// The candidates are Voronoi vertices; of each edge the far point, where the longer way from one
// centre to the other along their great circle meets it; and the point opposite to the only site
// (docs/PROOFS.md, "The sphere").
import type { NativeSphericalDiagram } from "../core/native/module.js";
import { apart } from "../shapes/empty_circles.js";
import type { SphericalEmptyCircle } from "./spherical_types.js";

const kRounding = 1e-12; // radians, of places
const kDegree = Math.PI / 180;

type Vector = readonly [x: number, y: number, z: number];

function vectorOf(lon: number, lat: number): Vector {
  const across = Math.cos(lat * kDegree);
  return [
    across * Math.cos(lon * kDegree),
    across * Math.sin(lon * kDegree),
    Math.sin(lat * kDegree),
  ];
}

const dot = (a: Vector, b: Vector) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const sum = (s: number, a: Vector, t: number, b: Vector): Vector => [
  s * a[0] + t * b[0],
  s * a[1] + t * b[1],
  s * a[2] + t * b[2],
];
const lengthOf = (a: Vector) => Math.hypot(...a);
/** In radians, accurate for small angles, too. */
const angleBetween = (a: Vector, b: Vector) =>
  2 * Math.atan2(lengthOf(sum(1, a, -1, b)), lengthOf(sum(1, a, 1, b)));

/** The `most` largest ones, none of which has its centre in one before it. */
export function emptyCircles(native: NativeSphericalDiagram, most: number): SphericalEmptyCircle[] {
  if (native.size() === 0) return [];
  const radius = native.radius();
  const { coordinates, clearance, sites } = native.vertices();
  const candidates = Array.from(clearance, (r, k) => ({
    lon: coordinates[2 * k]!,
    lat: coordinates[2 * k + 1]!,
    r,
    site: sites[3 * k]!,
  }));
  for (const point of farPoints(native, radius)) candidates.push(point);
  candidates.sort((a, b) => b.r - a.r || a.lon - b.lon || a.lat - b.lat);
  const places = new Map(candidates.map((one) => [one, vectorOf(one.lon, one.lat)]));
  return apart(candidates, most, (a, b) => radius * angleBetween(places.get(a)!, places.get(b)!));
}

/** Where edges are farthest from their sites between their ends. */
function farPoints(native: NativeSphericalDiagram, radius: number): SphericalEmptyCircle[] {
  const { sites } = native.edges();
  const places: number[] = [];
  const expected: number[] = [];
  const add = (point: Vector, distance: number) => {
    places.push(Math.atan2(point[1], point[0]) / kDegree);
    places.push(Math.atan2(point[2], Math.hypot(point[0], point[1])) / kDegree);
    expected.push(distance);
  };
  const capOf = (id: number) => {
    const { lon, lat, r } = native.site(id);
    return { centre: vectorOf(lon, lat), weight: r / radius };
  };
  for (let k = 0; k < sites.length; k += 2) {
    const [a, b] = [capOf(sites[k]!), capOf(sites[k + 1]!)];
    const between = angleBetween(a.centre, b.centre);
    const away = (2 * Math.PI - between + a.weight - b.weight) / 2;
    const unit = tangent(a.centre, b.centre);
    add(sum(Math.cos(away), a.centre, -Math.sin(away), unit), away - a.weight);
  }
  if (native.visibleSize() === 1) {
    const { id } = native.nearest(0, 0);
    const { centre, weight } = capOf(id);
    add(sum(-1, centre, 0, centre), Math.PI - weight);
  }
  const [ids, distances] = [new Int32Array(expected.length), new Float64Array(expected.length)];
  native.findMany(places, ids, distances);
  return Array.from(ids, (site, k) => ({
    lon: places[2 * k]!,
    lat: places[2 * k + 1]!,
    r: distances[k]!,
    site,
  })).filter(({ r }, k) => r >= radius * (expected[k]! - kRounding));
}

/** The direction of one unit vector as seen from another; any, if they are opposite. */
function tangent(from: Vector, to: Vector): Vector {
  const way = sum(1, to, -dot(from, to), from);
  if (lengthOf(way) < kRounding) {
    const [x, y] = from;
    return Math.hypot(x, y) < 0.5 ? unit([0, 1, 0], from) : unit([-y, x, 0], from);
  }
  return unit(sum(1 / lengthOf(way), way, 0, way), from);
}

/** Of length 1, and at right angles to a unit vector. */
function unit(vector: Vector, to: Vector): Vector {
  const across = sum(1, vector, -dot(vector, to), to);
  return sum(1 / lengthOf(across), across, 0, across);
}
