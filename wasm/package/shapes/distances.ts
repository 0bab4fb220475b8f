// How far the cells of a view reach, as callers give it.
import { checkNumber } from "../core/arguments.js";
import type { Diagram } from "../core/diagram.js";
import type { NativeDiagram } from "../core/native/module.js";
import { ApolloniusError } from "../errors.js";
import { numbersById } from "./by_id.js";
import type { VoronoiOptions } from "./types.js";

/** Infinity, where cells end nowhere but at others. */
export function distanceOf(
  native: NativeDiagram,
  options: VoronoiOptions | undefined,
): number | ArrayLike<number> {
  const distance = options?.distance ?? Infinity;
  if (typeof distance === "object")
    return Float64Array.from(numbersById(native, "distance", distance, "bad-option"));
  if (distance !== Infinity) checkNumber("distance", distance);
  return distance;
}

/** Is this site the nearest one, and does it reach so far? */
export function reaches(
  diagram: Diagram,
  distance: number | ArrayLike<number>,
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
