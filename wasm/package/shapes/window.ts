// The window of a view as a thing: what it measures, and what is in it.
import { checkNumber, taken } from "../core/arguments.js";
import type { NativeRegion, NativeShapes } from "../core/native/module.js";
import type { Bounds } from "../core/types.js";
import type { VoronoiWindow as Shape } from "./types.js";

type Centroid = Shape["centroid"];

/** A class, as methods that are properties would keep equal views from being equal to tests. */
class VoronoiWindow implements Shape {
  readonly area: number;
  readonly centroid: Centroid;
  readonly #region: NativeRegion | null;
  readonly #livingNow: () => NativeShapes;

  constructor(
    readonly bounds: Bounds,
    region: NativeRegion | null,
    livingNow: () => NativeShapes,
  ) {
    const [xmin, ymin, xmax, ymax] = Object.freeze(bounds);
    this.area = region ? region.area() : (xmax - xmin) * (ymax - ymin);
    this.centroid = Object.freeze<Centroid>(
      region
        ? [region.centroidX(), region.centroidY()]
        : [xmin / 2 + xmax / 2, ymin / 2 + ymax / 2],
    );
    this.#region = region;
    this.#livingNow = livingNow;
    Object.freeze(this);
  }

  contains(x: number, y: number): boolean {
    checkNumber("x", x);
    checkNumber("y", y);
    this.#livingNow();
    if (this.#region) return this.#region.contains(x, y);
    const [xmin, ymin, xmax, ymax] = this.bounds;
    const left = taken(x),
      low = taken(y);
    return xmin <= left && left <= xmax && ymin <= low && low <= ymax;
  }
}

/** @internal `livingNow` throws unless the view is there, with its region. */
export function windowOf(
  bounds: Bounds,
  region: NativeRegion | null,
  livingNow: () => NativeShapes,
): Shape {
  return new VoronoiWindow(bounds, region, livingNow);
}
