// The window of a view as a thing: what it measures, and what is in it.
import { checkNumber } from "./arguments.js";
import type { NativeRegion } from "./module.js";
import type { Bounds } from "./types.js";

/**
 * The window that cells are clipped to, `voronoi.window`. Of a region that is what is inside by the
 * even-odd rule, holes left out. Frozen; measures are computed when the view is made.
 */
export interface VoronoiWindow {
  /** The smallest box that holds it. */
  readonly bounds: Bounds;
  /** Its area, above 0, in the square of the diagram's unit: what `cellAreas` adds up to. */
  readonly area: number;
  /** Its centroid. */
  readonly centroid: readonly [x: number, y: number];
  /**
   * Is a point inside, or on the border? Exact for the rings that `renderBounds` draws: where the
   * given ones cross, these have the crossing as rounded. O(1), or O(m) for a region of m points.
   * Throws "not-finite", "out-of-range", and "disposed" once the view or the diagram is.
   */
  contains(x: number, y: number): boolean;
}

/** `expectLiving` throws unless the region, if there is one, is there. */
export function windowOf(
  bounds: Bounds,
  region: NativeRegion | null,
  expectLiving: () => unknown,
): VoronoiWindow {
  const [xmin, ymin, xmax, ymax] = bounds;
  const [x, y] = region?.centroid() ?? [xmin / 2 + xmax / 2, ymin / 2 + ymax / 2];
  return Object.freeze({
    bounds: Object.freeze(bounds),
    area: region?.area() ?? (xmax - xmin) * (ymax - ymin),
    centroid: Object.freeze([x, y] as [number, number]),
    contains(px: number, py: number): boolean {
      checkNumber("x", px);
      checkNumber("y", py);
      expectLiving();
      return region?.contains(px, py) ?? (xmin <= px && px <= xmax && ymin <= py && py <= ymax);
    },
  });
}
