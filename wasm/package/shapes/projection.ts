// Windows and polygons of a map: there by a projection, and back.
//
// Straight lines of the plane and of longitude and latitude are different lines. So sides are
// halved until they are the same up to a tolerance in the plane, the same way in both directions,
// so that neighbours keep their points in common.
import type { CoverageArrays } from "../../../build/wasm/apollonius.mjs";
import { checkedBounds, described } from "../core/arguments.js";
import type { Position } from "../core/types.js";
import { ApolloniusError } from "../errors.js";
import { length } from "./curves.js";
import { checkedRings, type FlatRings, isRegion, readOnce } from "./region.js";
import type { Projection } from "./types.js";

const kDeepest = 16; // halvings of a side
const kShare = 2 ** -13; // of a window's diagonal, what its sides may be off
/** Where sides are compared: the middle alone is right where a curve is an S about it. */
const kProbes = [19 / 64, 1 / 2, 45 / 64];

/** A point as it is given, and its image. */
type Mapped = { from: Position; to: Position };

/** Throws "bad-option". */
export function checkedProjection(project: unknown): Projection | undefined {
  if (project === undefined) return undefined;
  if (typeof project === "function" && "invert" in project && typeof project.invert === "function")
    return project as Projection;
  throw new ApolloniusError(
    "bad-option",
    `options.project is ${described(project)}, expected a function of [longitude, latitude] with ` +
      "a method invert, as d3-geo's projections are",
  );
}

/** A window as callers give it, in the plane: bounds, or rings. Throws "bad-bounds". */
export function readWindow(
  given: unknown,
  project: Projection | undefined,
): FlatRings | [number, number, number, number] {
  const window = readOnce(given);
  if (isRegion(window)) {
    const rings = checkedRings(window);
    return project ? projectedRings(rings, project) : rings;
  }
  const bounds = checkedBounds(window);
  if (!project) return bounds;
  const [west, south, east, north] = bounds;
  return projectedRings(
    checkedRings([[west, south, east, south, east, north, west, north]]),
    project,
  );
}

/** Rings of longitudes and latitudes in the plane. Throws "bad-bounds" for what is not on it. */
function projectedRings({ coordinates, starts }: FlatRings, project: Projection): FlatRings {
  const map = (place: Position) => toPlane(project, place);
  const tolerance = kShare * diagonalOf(coordinates, map);
  return refine(coordinates, starts, map, (from, to) => distance(map(from), to) <= tolerance);
}

/** Polygons of the plane as longitudes and latitudes, counter-clockwise there. */
export function unprojected(
  coverage: CoverageArrays,
  project: Projection,
  tolerance: number,
): CoverageArrays {
  const toMap = (point: Position): Position => {
    const place = project.invert(point);
    if (place && Number.isFinite(place[0]) && Number.isFinite(place[1])) return place;
    throw new ApolloniusError(
      "bad-option",
      `options.project.invert knows no place for the point ${point}: choose a smaller window`,
    );
  };
  const { coordinates, starts } = refine(
    coverage.coordinates,
    coverage.starts,
    toMap,
    (from, to) => distance(from, project(to) ?? [NaN, NaN]) <= tolerance,
  );
  let area = 0; // of the first ring of each polygon
  for (const ring of coverage.parts.subarray(0, -1))
    area += areaOf(coordinates.subarray(2 * starts[ring]!, 2 * starts[ring + 1]!));
  if (area < 0) reverseRings(coordinates, starts); // y points downwards in most planes of maps
  return { ...coverage, coordinates, starts };
}

function toPlane(project: Projection, place: Position): Position {
  const point = project(place);
  if (point && Number.isFinite(point[0]) && Number.isFinite(point[1])) return point;
  throw new ApolloniusError(
    "bad-bounds",
    `options.project knows no point for the place ${place} of the window`,
  );
}

const between = (a: Position, b: Position, part: number): Position => [
  a[0] * (1 - part) + b[0] * part,
  a[1] * (1 - part) + b[1] * part,
];
const distance = (a: Position, b: Position) => length(a[0] - b[0], a[1] - b[1]);
const positionAt = (xy: ArrayLike<number>, k: number): Position => [xy[2 * k]!, xy[2 * k + 1]!];

/**
 * The images of rings whose sides are halved until areClose(from, to) for points of a side and of
 * its image; closed rings stay closed, open ones open.
 */
function refine(
  coordinates: Float64Array,
  starts: Uint32Array,
  map: (position: Position) => Position,
  areClose: (from: Position, to: Position) => boolean,
): FlatRings {
  const images: number[] = [];
  const ends = [0];
  const mapped = (from: Position): Mapped => ({ from, to: map(from) });
  const follow = (a: Mapped, b: Mapped, depth: number): void => {
    const isFine = (part: number) =>
      areClose(between(a.from, b.from, part), between(a.to, b.to, part));
    if (depth === 0 || kProbes.every(isFine)) return;
    const middle = mapped(between(a.from, b.from, 1 / 2));
    follow(a, middle, depth - 1);
    images.push(...middle.to);
    follow(middle, b, depth - 1);
  };
  for (let ring = 0; ring + 1 < starts.length; ++ring) {
    const points: Mapped[] = [];
    for (let k = starts[ring]!; k < starts[ring + 1]!; ++k)
      points.push(mapped(positionAt(coordinates, k)));
    const isClosed = distance(points[0]!.from, points.at(-1)!.from) === 0;
    points.forEach((point, k) => {
      images.push(...point.to);
      const next = points[k + 1] ?? (isClosed ? undefined : points[0]);
      if (next) follow(point, next, kDeepest);
    });
    ends.push(images.length / 2);
  }
  return { coordinates: Float64Array.from(images), starts: Uint32Array.from(ends) };
}

function diagonalOf(xy: Float64Array, map: (position: Position) => Position): number {
  let [xmin, ymin, xmax, ymax] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let k = 0; 2 * k < xy.length; ++k) {
    const [x, y] = map(positionAt(xy, k));
    xmin = Math.min(xmin, x);
    xmax = Math.max(xmax, x);
    ymin = Math.min(ymin, y);
    ymax = Math.max(ymax, y);
  }
  return length(xmax - xmin, ymax - ymin);
}

/** Twice the area of a closed ring. */
function areaOf(ring: Float64Array): number {
  let sum = 0;
  for (let k = 0; k + 3 < ring.length; k += 2)
    sum +=
      (ring[k]! - ring[0]!) * (ring[k + 3]! - ring[1]!) -
      (ring[k + 2]! - ring[0]!) * (ring[k + 1]! - ring[1]!);
  return sum;
}

function reverseRings(coordinates: Float64Array, starts: Uint32Array): void {
  for (let ring = 0; ring + 1 < starts.length; ++ring) {
    // Numbers the other way round, and then each pair.
    const numbers = coordinates.subarray(2 * starts[ring]!, 2 * starts[ring + 1]!).reverse();
    for (let k = 0; k < numbers.length; k += 2)
      [numbers[k], numbers[k + 1]] = [numbers[k + 1]!, numbers[k]!];
  }
}
