// Which numbers the sphere accepts, and items as its sites.
import type { Accessor, Items } from "../core/accessors.js";
import {
  allocated,
  checkOptions,
  checkSiteCount,
  described,
  detachedArray,
  isArrayLike,
  isDetached,
} from "../core/arguments.js";
import {
  type AnyNative,
  type NativeSphericalDiagram,
  runningModule,
} from "../core/native/module.js";
import type { Space } from "../core/space.js";
import { ApolloniusError } from "../errors.js";

function notFinite(name: string, value: unknown): ApolloniusError {
  return new ApolloniusError(
    "not-finite",
    `${name} is ${described(value)}, expected a finite number`,
  );
}

/**
 * The error of a longitude (axis 0), a latitude or a weight; null if it is fine. Names are made for
 * errors only, as they cost more than the check.
 */
function errorOf(
  nameOf: () => string,
  axis: number,
  value: unknown,
  radius: number,
): ApolloniusError | null {
  if (!Number.isFinite(value)) return notFinite(nameOf(), value);
  if (axis === 1 && Math.abs(value as number) > 90)
    return new ApolloniusError(
      "out-of-range",
      `${nameOf()} is ${value}, expected a latitude from -90 to 90: longitude comes first, then ` +
        "latitude",
    );
  if (axis === 2 && !(Math.abs(value as number) / radius < Math.PI))
    return new ApolloniusError(
      "out-of-range",
      `${nameOf()} is ${value}, expected less than half a great circle, ${Math.PI * radius}: the ` +
        `radius of the sphere is ${radius}`,
    );
  return null;
}

const radiusOf = (native: AnyNative) => (native as NativeSphericalDiagram).radius();

export const sphere: Space = {
  names: ["lon", "lat", "r"],
  sites: "lonLatR",
  points: "lonLat",
  error: (name, axis, value, native) => errorOf(() => name, axis, value, radiusOf(native)),
  empty: (like) => runningModule().createSpherical(radiusOf(like)),
};

export function checkedRadius(options: { radius?: unknown } | undefined): number {
  const radius = options?.radius ?? 1;
  if (typeof radius !== "number" || !Number.isFinite(radius))
    throw notFinite("options.radius", radius);
  if (radius >= 1e-100 && radius <= 1e100) return radius;
  throw new ApolloniusError(
    "out-of-range",
    `options.radius is ${radius}, expected a number from 1e-100 to 1e100`,
  );
}

const kTolerance = 1e-4;
const kFinestTolerance = 1e-9; // as in src/apollonius/spherical_diagram.h

export function checkedAngularTolerance(tolerance: unknown): number {
  if (tolerance === undefined) return kTolerance;
  if (typeof tolerance !== "number" || !Number.isFinite(tolerance))
    throw notFinite("options.tolerance", tolerance);
  if (tolerance >= kFinestTolerance) return tolerance;
  throw new ApolloniusError(
    "out-of-range",
    `options.tolerance is ${tolerance}, expected radians from 1e-9 on`,
  );
}

// --- Items ---------------------------------------------------------------------------------------

/** Accessors of items; what is missing is read as from a `Spherical`. */
export interface SphericalAccessors<T> {
  lon: Accessor<T> | undefined;
  lat: Accessor<T> | undefined;
  r: Accessor<T> | undefined;
}

type Fields = { readonly [name: string]: unknown } & ArrayLike<unknown>;

/** Longitude, latitude and weight of an item without accessors; undefined if it is none. */
function defaultFields(item: unknown): [lon: unknown, lat: unknown, r: unknown] | undefined {
  if (typeof item !== "object" || item === null) return undefined;
  const fields = item as Fields;
  if (Array.isArray(item) || ArrayBuffer.isView(item)) return [fields[0], fields[1], fields[2]];
  const geometry = (fields.type === "Feature" ? fields.geometry : fields) as Fields | null;
  if (geometry?.type === "Point" && isArrayLike(geometry.coordinates))
    return [geometry.coordinates[0], geometry.coordinates[1], undefined];
  return "lon" in fields && "lat" in fields ? [fields.lon, fields.lat, fields.r] : undefined;
}

/** Items that are read in portions, whatever the accessors do to them. */
export class SphericalReader<T> {
  readonly count: number;
  readonly #items: Items<T>;
  readonly #list: ArrayLike<T>;
  readonly #accessors: SphericalAccessors<T>;
  readonly #radius: number;

  /** Throws "bad-length", "too-large", and "bad-option" if an accessor is no function. */
  constructor(given: Items<T>, accessors: SphericalAccessors<T>, radius: number) {
    for (const [name, accessor] of Object.entries(accessors)) {
      if (accessor === undefined || typeof accessor === "function") continue;
      throw new ApolloniusError(
        "bad-option",
        `${name} is ${described(accessor)}, expected a function of an item`,
      );
    }
    const collection = given as { type?: unknown; features?: unknown } | null;
    const items = (
      collection?.type === "FeatureCollection" ? collection.features : given
    ) as Items<T>;
    if (isDetached(items)) throw detachedArray("items", "items");
    const isIterable = typeof items === "object" && items !== null && Symbol.iterator in items;
    const list = isIterable ? Array.from(items) : (items as ArrayLike<T>);
    if (!isArrayLike(list))
      throw new ApolloniusError(
        "bad-length",
        `items is ${described(items)}, expected an iterable or an array`,
      );
    this.count = list.length; // accessors may change the list
    checkSiteCount("items", this.count);
    this.#items = items;
    this.#list = list;
    this.#accessors = accessors;
    this.#radius = radius;
  }

  /**
   * The triples of the items from one to before another. Throws "not-finite" or "out-of-range",
   * naming the item, for values that cannot be a site's.
   */
  triples(from: number, to: number): Float64Array {
    const { lon, lat, r } = this.#accessors;
    const triples = allocated(() => new Float64Array(3 * (to - from)));
    for (let index = from; index < to; ++index) {
      const item = this.#list[index] as T;
      const usual = lon && lat ? [] : defaultFields(item);
      if (usual === undefined)
        throw new ApolloniusError(
          "not-finite",
          `item ${index} is ${described(item)}, expected {lon, lat, r}, [lon, lat, r] or a ` +
            "GeoJSON point",
        );
      const values = [
        lon ? lon(item, index, this.#items) : usual[0],
        lat ? lat(item, index, this.#items) : usual[1],
        r ? r(item, index, this.#items) : (usual[2] ?? 0),
      ];
      values.forEach((value, axis) => {
        const nameOf = () => `${["lon", "lat", "r"][axis]} of item ${index}`;
        const error =
          typeof value === "number"
            ? errorOf(nameOf, axis, value, this.#radius)
            : notFinite(nameOf(), value);
        if (error) throw error;
        triples[3 * (index - from) + axis] = value as number;
      });
    }
    return triples;
  }
}

/** Accessors and options of these names, of which the latter may come at any place. */
export function accessorsAndOptions<T>(
  rest: unknown[],
  ...names: string[]
): {
  accessors: SphericalAccessors<T>;
  options: object | undefined;
} {
  const at = rest.findIndex((given) => typeof given === "object" && given !== null);
  const options = at === -1 ? undefined : (rest[at] as object);
  checkOptions(options, ...names);
  const [lon, lat, r] = (at === -1 ? rest : rest.slice(0, at)) as (Accessor<T> | undefined)[];
  return { accessors: { lon, lat, r }, options };
}
