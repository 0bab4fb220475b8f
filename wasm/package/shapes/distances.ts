// How far the cells of a view reach, as callers give it.
import { checkNumber } from "../core/arguments.js";
import type { Diagram } from "../core/diagram.js";
import type { AnyNative } from "../core/native/module.js";
import { ofElements } from "../core/native/native_errors.js";
import { ApolloniusError } from "../errors.js";
import { numbersById } from "./by_id.js";
import type { DistanceOptions } from "./types.js";

/** One for all sites, or an array by id. */
export type Distances = number | ArrayLike<number>;

/** Infinity, where cells end nowhere but at others. */
export function distanceOf(native: AnyNative, options: DistanceOptions | undefined): Distances {
  const distance = options?.distance ?? Infinity;
  if (typeof distance === "object")
    return Float64Array.from(numbersById(native, "distance", distance, "bad-option"));
  if (distance !== Infinity) checkNumber("distance", distance);
  return distance;
}

/** What a call says of distances as the module takes them; errors name the first bad one. */
export function withDistances<Answer>(
  distances: Distances,
  call: (distances: ArrayLike<number>, isById: boolean) => Answer,
): Answer {
  if (typeof distances === "number") return call([distances], false);
  try {
    return call(distances, true);
  } catch (error) {
    const finite = Array.from(distances, (value) => (value === Infinity ? 0 : value));
    throw ofElements(error, "distance", finite);
  }
}

/** Is this site the nearest one, and does it reach so far? */
export function reaches(
  diagram: Diagram,
  distance: Distances,
  id: number,
  x: number,
  y: number,
): boolean {
  if (distance === Infinity) return diagram.find(x, y) === id;
  const most = typeof distance === "number" ? distance : distance[id];
  if (most === undefined) throw newcomer(id);
  const nearest = diagram.nearest(x, y);
  return nearest?.id === id && nearest.distance <= most;
}

function newcomer(id: number): ApolloniusError {
  return new ApolloniusError(
    "bad-length",
    `site ${id} was inserted after the view was made and has no distance`,
  );
}
