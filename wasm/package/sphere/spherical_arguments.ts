// Argument checks of the sphere, and items as sites. The library checks the same numbers and cannot
// say which one is wrong.
import type { Accessor, Items } from "../core/accessors.js";
import {
  allocated,
  checkedNumbers,
  checkOptions,
  checkSiteCount,
  described,
  detachedArray,
  isArrayLike,
  isDetached,
} from "../core/arguments.js";
import { ApolloniusError } from "../errors.js";

function notFinite(name: string, value: unknown): ApolloniusError {
  return new ApolloniusError(
    "not-finite",
    `${name} is ${described(value)}, expected a finite number`,
  );
}

function lonError(name: string, lon: unknown): ApolloniusError | null {
  return Number.isFinite(lon) ? null : notFinite(name, lon);
}

function latError(name: string, lat: unknown): ApolloniusError | null {
  if (!Number.isFinite(lat)) return notFinite(name, lat);
  if (Math.abs(lat as number) <= 90) return null;
  return new ApolloniusError(
    "out-of-range",
    `${name} is ${lat}, expected a latitude from -90 to 90: longitude comes first, then latitude`,
  );
}

function weightError(name: string, r: unknown, radius: number): ApolloniusError | null {
  if (!Number.isFinite(r)) return notFinite(name, r);
  if (Math.abs(r as number) / radius < Math.PI) return null;
  return new ApolloniusError(
    "out-of-range",
    `${name} is ${r}, expected less than half a great circle, ${Math.PI * radius}: the radius of ` +
      `the sphere is ${radius}`,
  );
}

export function checkPoint(lon: unknown, lat: unknown): void {
  const error = lonError("lon", lon) ?? latError("lat", lat);
  if (error) throw error;
}

export function checkSite(lon: unknown, lat: unknown, r: unknown, radius: number): void {
  checkPoint(lon, lat);
  const error = weightError("r", r, radius);
  if (error) throw error;
}

/** Throws for the first element with an error; its name is made only then. */
function checkElements(
  numbers: ArrayLike<number>,
  perItem: number,
  radius: number,
  nameOf: (k: number) => string,
): void {
  const most = Math.PI * radius;
  for (let k = 0; k < numbers.length; ++k) {
    const value = numbers[k] as number;
    const axis = k % perItem;
    const limit = axis === 0 ? Infinity : axis === 1 ? 90 : most;
    if (Math.abs(value) < limit) continue;
    const of = nameOf(k);
    const error =
      axis === 0
        ? lonError(of, value)
        : axis === 1
          ? latError(of, value)
          : weightError(of, value, radius);
    if (error) throw error;
  }
}

/** Flat longitude, latitude, weight triples. */
export function checkedSites(name: string, values: unknown, radius: number): ArrayLike<number> {
  const numbers = checkedNumbers(name, values, 3);
  checkSiteCount(name, numbers.length / 3);
  checkElements(numbers, 3, radius, (k) => `${name}[${k}]`);
  return numbers;
}

/** Flat longitude, latitude pairs. */
export function checkedPoints(name: string, values: unknown): ArrayLike<number> {
  const numbers = checkedNumbers(name, values, 2);
  checkElements(numbers, 2, 1, (k) => `${name}[${k}]`);
  return numbers;
}

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

/** The triples of items; throws naming the item, and "bad-option" if an accessor is no function. */
export function sphericalTriples<T>(
  given: Items<T>,
  accessors: SphericalAccessors<T>,
  radius: number,
): Float64Array {
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
  checkSiteCount("items", list.length);
  const { lon, lat, r } = accessors;
  const nameOf = (k: number) => `${["lon", "lat", "r"][k % 3]} of item ${Math.floor(k / 3)}`;
  const triples = allocated(() => new Float64Array(3 * list.length));
  for (let k = 0; k < list.length; ++k) {
    const item = list[k] as T;
    const usual = lon && lat ? [] : defaultFields(item);
    if (usual === undefined)
      throw new ApolloniusError(
        "not-finite",
        `item ${k} is ${described(item)}, expected {lon, lat, r}, [lon, lat, r] or a GeoJSON point`,
      );
    const values = [
      lon ? lon(item, k, items) : usual[0],
      lat ? lat(item, k, items) : usual[1],
      r ? r(item, k, items) : (usual[2] ?? 0),
    ];
    for (let axis = 0; axis < 3; ++axis) {
      const value = values[axis];
      if (typeof value !== "number") throw notFinite(nameOf(3 * k + axis), value);
      triples[3 * k + axis] = value;
    }
  }
  checkElements(triples, 3, radius, nameOf);
  return triples;
}

/** Accessors and options, of which the latter may come at any place. */
export function accessorsAndOptions<T>(rest: unknown[]): {
  accessors: SphericalAccessors<T>;
  options: object | undefined;
} {
  const at = rest.findIndex((given) => typeof given === "object" && given !== null);
  const options = at === -1 ? undefined : (rest[at] as object);
  checkOptions(options, "radius");
  const [lon, lat, r] = (at === -1 ? rest : rest.slice(0, at)) as (Accessor<T> | undefined)[];
  return { accessors: { lon, lat, r }, options };
}
