// Windows of any shape, as callers give them: rings of points, flat rings, GeoJSON.
import { described, isArrayLike, numberError, plainView, taken } from "../core/arguments.js";
import type { Bounds } from "../core/types.js";
import { ApolloniusError } from "../errors.js";

/**
 * A closed ring: an array of points [x, y], whose further numbers (heights) are ignored, or flat x,
 * y, …. The first point may be repeated at the end.
 */
export type Ring = ArrayLike<ArrayLike<number>> | ArrayLike<number>;

/** A GeoJSON object that can be a window. */
export type GeoJSONRegion =
  | { readonly type: "Polygon"; readonly coordinates: ArrayLike<Ring> }
  | { readonly type: "MultiPolygon"; readonly coordinates: ArrayLike<ArrayLike<Ring>> }
  | {
      readonly type: "Feature";
      readonly geometry: GeoJSONRegion | { readonly type: string } | null;
    }
  | { readonly type: "FeatureCollection"; readonly features: ArrayLike<GeoJSONRegion> };

/**
 * A window of any shape: a ring, several rings, or GeoJSON (a Polygon, a MultiPolygon, a Feature of
 * either, or a FeatureCollection of these; coordinates are taken as plane ones). The results of
 * `cellPolygon`, `cellParts` and `toGeoJSON` are regions, too.
 *
 * A point is inside if a line from it to infinity crosses the rings an odd number of times
 * (even-odd rule), whatever their directions: holes and islands are rings like any other. Rings may
 * cross and touch themselves and each other, repeat points, and overlap: overlaps of two rings are
 * outside.
 */
export type Region = Ring | ArrayLike<Ring> | ArrayLike<ArrayLike<Ring>> | GeoJSONRegion;

/** A disc: its centre and its radius, > 0. */
export interface Disc {
  /** The centre's x. */
  readonly x: number;
  /** The centre's y, which points upwards. */
  readonly y: number;
  /** Radius, > 0. */
  readonly r: number;
}

/**
 * The window of a view: bounds; a region; or a disc, which is taken as the polygon of 512 points on
 * its circle.
 */
export type WindowShape = Bounds | Region | Disc;

/** Rings for the library: all points; the index of each ring's first, and the number of points. */
export interface FlatRings {
  // New arrays, for TypeScript before 5.7, too, where the types of arrays are not generic.
  coordinates: ReturnType<Float64Array["slice"]>;
  starts: ReturnType<Uint32Array["slice"]>;
}

/** Copies an array that may be bounds: getters of its elements may give other values later. */
export function readOnce<Window>(window: Window): Window | unknown[] {
  if (!isArrayLike(window) || window.length !== 4) return window;
  return [0, 1, 2, 3].map((k) => window[k]);
}

/** Is it a window of any shape, rather than bounds? */
export function isRegion(window: unknown): boolean {
  if (isArrayLike(window))
    return isArrayLike(window[0]) || (window.length >= 6 && typeof window[0] === "number");
  return typeof window === "object" && window !== null && ("type" in window || "r" in window);
}

/** Returns the rings of a region; throws "bad-bounds", naming ring and point. */
export function checkedRings(region: unknown): FlatRings {
  const coordinates: number[] = [];
  const starts = [0];
  addRings(ringOfDisc(region) ?? ringsOf(region), coordinates, starts, 0);
  if (starts.length === 1) throw bad("the region has no rings");
  return { coordinates: Float64Array.from(coordinates), starts: Uint32Array.from(starts) };
}

function bad(message: string): ApolloniusError {
  return new ApolloniusError("bad-bounds", message);
}

const kHalvings = 7; // how often each quarter of a disc's circle is halved

/** Returns the circle of a disc as a ring; undefined if it is no disc. Throws "bad-bounds". */
function ringOfDisc(disc: unknown): [number, number][] | undefined {
  if (typeof disc !== "object" || disc === null || isArrayLike(disc) || !("r" in disc))
    return undefined;
  const { x, y, r } = disc as unknown as Disc;
  for (const [name, value] of Object.entries({ x, y, r })) {
    const error = numberError(`${name} of the disc`, value);
    if (error) throw bad(error.message);
  }
  if (!(taken(r) > 0)) throw bad(`r of the disc is ${r}, expected a number above 0`);
  let directions: [number, number][] = [
    [1, 0],
    [0, 1],
    [-1, 0],
    [0, -1],
  ];
  for (let halving = 0; halving < kHalvings; ++halving)
    directions = directions.flatMap(([a, b], k) => {
      const [c, d] = directions[(k + 1) % directions.length]!;
      const [u, v] = [a + c, b + d];
      const size = Math.sqrt(u * u + v * v);
      return [
        [a, b],
        [u / size, v / size],
      ];
    });
  return directions.map(([u, v]) => [x + r * u, y + r * v]);
}

/** The GeoJSON types that can be a window; each may hold those after it. */
const kTypes = ["FeatureCollection", "Feature", "Polygon", "MultiPolygon"];

/** Returns the rings in a GeoJSON object of one of the types; arrays are returned unchanged. */
function ringsOf(region: unknown, types = kTypes): unknown {
  if (isArrayLike(region)) return region;
  const { type, geometry, features, coordinates } = (region ?? {}) as Record<string, unknown>;
  const at = types.indexOf(type as string);
  const inner = (item: unknown) => ringsOf(item, kTypes.slice(kTypes.indexOf(type as string) + 1));
  if (at >= 0 && type === "FeatureCollection" && isArrayLike(features))
    return Array.from(features, inner);
  if (at >= 0 && type === "Feature" && geometry !== null) return inner(geometry);
  if (at >= 0 && (type === "Polygon" || type === "MultiPolygon")) return coordinates;
  const what =
    type === "Feature" && geometry === null
      ? "a Feature without geometry"
      : `an object of type ${typeof type === "string" ? type : described(type)}`;
  throw bad(
    `the region is ${what}, expected rings, or GeoJSON of type ${types.slice(0, -1).join(", ")} ` +
      `or ${types.at(-1)}`,
  );
}

// The depth of nesting: collections hold multi-polygons, these hold polygons, these hold rings.
const kDeepest = 3;

function addRings(given: unknown, coordinates: number[], starts: number[], depth: number): void {
  if (depth > kDeepest) throw bad(`ring ${starts.length - 1} of the region is nested too deep`);
  const rings = plainView(given);
  if (!isArrayLike(rings)) throw bad(`ring ${starts.length - 1} of the region is no array`);
  if (rings.length === 0) return;
  const first = rings[0];
  const isOfPoints = isArrayLike(first) && typeof first[0] === "number" && first.length <= 3;
  if (isOfPoints || !isArrayLike(first)) {
    addRing(rings, isOfPoints, coordinates, starts);
  } else {
    for (let k = 0; k < rings.length; ++k) addRings(rings[k], coordinates, starts, depth + 1);
  }
}

function addRing(
  ring: ArrayLike<unknown>,
  isOfPoints: boolean,
  coordinates: number[],
  starts: number[],
): void {
  const number = starts.length - 1;
  if (!isOfPoints && ring.length % 2 !== 0)
    throw bad(`ring ${number} of the region has ${ring.length} numbers, expected pairs of x and y`);
  const begin = coordinates.length;
  const count = isOfPoints ? ring.length : ring.length / 2;
  for (let k = 0; k < count; ++k) {
    const point = isOfPoints ? (ring[k] as ArrayLike<unknown> | undefined) : undefined;
    const x = isOfPoints ? point?.[0] : ring[2 * k];
    const y = isOfPoints ? point?.[1] : ring[2 * k + 1];
    const where = `of point ${k} in ring ${number} of the region`;
    const error = numberError(`x ${where}`, x) ?? numberError(`y ${where}`, y);
    if (error) throw bad(error.message);
    coordinates.push(x as number, y as number);
  }
  const isClosed =
    coordinates[begin] === coordinates.at(-2) && coordinates[begin + 1] === coordinates.at(-1);
  if (isClosed && count > 1) coordinates.length -= 2;
  const kept = (coordinates.length - begin) / 2;
  if (kept < 3)
    throw bad(`ring ${number} of the region has ${kept} points, expected at least three`);
  starts.push(coordinates.length / 2);
}
