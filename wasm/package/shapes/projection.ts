// Windows and polygons of a map: there by a projection, and back.
//
// Straight lines of the plane and of longitude and latitude are different
// lines. So sides are halved until they are the same up to a tolerance in the plane, the same
// way in both directions, so that neighbours keep their points in common.
import type { CoverageArrays } from "../../../build/wasm/apollonius.mjs";
import { checkedBounds, described } from "../core/arguments.js";
import type { Position } from "../core/types.js";
import { ApolloniusError } from "../errors.js";
import { checkedRings, type FlatRings, isRegion, readOnce } from "./region.js";
import type { Projection } from "./types.js";

const kDeepest = 16; // halvings of a side
const kShare = 2 ** -13; // of a window's diagonal, what its sides may be off

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
  const corners = mapped(coordinates, (place) => toPlane(project, place));
  const tolerance = kShare * diagonalOf(corners);
  const isFine = (a: Position, b: Position) => {
    const [x, y] = toPlane(project, middle(a, b));
    const [mx, my] = middle(toPlane(project, a), toPlane(project, b));
    return Math.hypot(x - mx, y - my) <= tolerance;
  };
  const refined = refine(coordinates, starts, isFine);
  return {
    ...refined,
    coordinates: mapped(refined.coordinates, (place) => toPlane(project, place)),
  };
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
  const isFine = (a: Position, b: Position) => {
    const [x, y] = project(middle(toMap(a), toMap(b))) ?? [NaN, NaN];
    const [mx, my] = middle(a, b);
    return Math.hypot(x - mx, y - my) <= tolerance;
  };
  const refined = refine(coverage.coordinates, coverage.starts, isFine);
  const coordinates = mapped(refined.coordinates, toMap);
  const { starts } = refined;
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

function middle(a: Position, b: Position): Position {
  return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
}

const positionAt = (xy: ArrayLike<number>, k: number): Position => [xy[2 * k]!, xy[2 * k + 1]!];

function mapped(
  xy: Float64Array,
  map: (position: Position) => Position,
): Float64Array<ArrayBuffer> {
  const result = new Float64Array(xy.length);
  for (let k = 0; 2 * k < xy.length; ++k) result.set(map(positionAt(xy, k)), 2 * k);
  return result;
}

/** The sides of rings, halved until they are fine; closed rings stay closed, open ones open. */
function refine(
  coordinates: Float64Array,
  starts: Uint32Array,
  isFine: (a: Position, b: Position) => boolean,
): FlatRings {
  const refined: number[] = [];
  const ends = [0];
  const follow = (a: Position, b: Position, depth: number): void => {
    if (depth > 0 && !isFine(a, b)) {
      const m = middle(a, b);
      follow(a, m, depth - 1);
      refined.push(...m);
      follow(m, b, depth - 1);
    }
  };
  for (let ring = 0; ring + 1 < starts.length; ++ring) {
    const first = starts[ring]!;
    const end = starts[ring + 1]!;
    const start = positionAt(coordinates, first);
    const last = positionAt(coordinates, end - 1);
    const isClosed = start[0] === last[0] && start[1] === last[1];
    for (let k = first; k < end; ++k) {
      const point = positionAt(coordinates, k);
      refined.push(...point);
      if (k + 1 < end) follow(point, positionAt(coordinates, k + 1), kDeepest);
      else if (!isClosed) follow(point, start, kDeepest);
    }
    ends.push(refined.length / 2);
  }
  return { coordinates: Float64Array.from(refined), starts: Uint32Array.from(ends) };
}

function diagonalOf(xy: Float64Array): number {
  let [xmin, ymin] = positionAt(xy, 0);
  let [xmax, ymax] = [xmin, ymin];
  for (let k = 0; k < xy.length; k += 2) {
    xmin = Math.min(xmin, xy[k]!);
    xmax = Math.max(xmax, xy[k]!);
    ymin = Math.min(ymin, xy[k + 1]!);
    ymax = Math.max(ymax, xy[k + 1]!);
  }
  return Math.hypot(xmax - xmin, ymax - ymin);
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
