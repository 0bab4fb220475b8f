// The parts of a view's window in the module, for diagrams of the same instance.
import { keep } from "../core/native/lifetime.js";
import type { NativeReach, NativeRegion, NativeShapes } from "../core/native/module.js";
import { ApolloniusError } from "../errors.js";

/** Makes a region in the diagram's instance of the module, which lives as long as its owner. */
export function createRegion(
  owner: object,
  diagram: NativeShapes,
  coordinates: Float64Array,
  starts: Uint32Array,
): NativeRegion {
  let native: NativeRegion;
  try {
    native = diagram.region(coordinates, starts) as NativeRegion;
  } catch (error) {
    if (!(error instanceof ApolloniusError && error.code === "bad-bounds")) throw error;
    throw new ApolloniusError(
      "bad-bounds",
      "the region has no area: its points are in line, or its rings cancel each other",
    );
  }
  keep(owner, native);
  return native;
}

/** Makes a reach, one for all cells, which lives as long as its owner. */
export function createReach(owner: object, diagram: NativeShapes, limit: number): NativeReach {
  const native = diagram.reach([limit], []) as NativeReach;
  keep(owner, native);
  return native;
}
