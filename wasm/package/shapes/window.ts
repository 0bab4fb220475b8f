// The window of a view as a thing: what it measures, and what is in it.
import type { Portion } from "../../../build/wasm/apollonius.mjs";
import { checkNumber, taken } from "../core/arguments.js";
import type { NativeRegion, NativeShapes } from "../core/native/module.js";
import { play } from "../core/path.js";
import type { Bounds } from "../core/types.js";
import { pathOfSides } from "./drawing.js";
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
    const middle: Centroid = [xmin / 2 + xmax / 2, ymin / 2 + ymax / 2];
    const { area, centroid } =
      region === null
        ? { area: (xmax - xmin) * (ymax - ymin), centroid: middle }
        : momentsOf(livingNow().drawRegion(region), middle);
    this.area = area;
    this.centroid = Object.freeze(centroid);
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

/** Of what is inside of closed rings, the inside on the left of each. */
function momentsOf(rings: Portion, [x0, y0]: Centroid): { area: number; centroid: Centroid } {
  let area = 0;
  let [firstX, firstY] = [0, 0];
  const sides = pathOfSides((fromX, fromY, x, y) => {
    const [ax, ay, bx, by] = [fromX - x0, fromY - y0, x - x0, y - y0];
    const twice = ax * by - bx * ay;
    area += twice / 2;
    firstX += (twice / 6) * (ax + bx);
    firstY += (twice / 6) * (ay + by);
  });
  play(sides, rings.commands, rings.coordinates);
  return { area, centroid: [x0 + firstX / area, y0 + firstY / area] };
}
