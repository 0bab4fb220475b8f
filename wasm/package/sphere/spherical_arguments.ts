// Which numbers the sphere accepts, and items as its sites.
import type { ItemKind, Items } from "../core/accessors.js";
import { described, isArrayLike } from "../core/arguments.js";
import { type Inner, innerOf, wrongReceiver } from "../core/inner.js";
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

/** The error of a longitude (axis 0), a latitude or a weight; null if it is fine. */
function errorOf(
  name: string,
  axis: number,
  value: unknown,
  radius: number,
): ApolloniusError | null {
  if (!Number.isFinite(value)) return notFinite(name, value);
  if (axis === 1 && Math.abs(value as number) > 90)
    return new ApolloniusError(
      "out-of-range",
      `${name} is ${value}, expected a latitude from -90 to 90: longitude comes first, then ` +
        "latitude",
    );
  if (axis === 2 && !(Math.abs(value as number) / radius < Math.PI))
    return new ApolloniusError(
      "out-of-range",
      `${name} is ${value}, expected less than half a great circle, ${Math.PI * radius}: the ` +
        `radius of the sphere is ${radius}`,
    );
  return null;
}

/** As innerOf; throws "bad-option" also for a diagram of the plane. */
export function sphericalOf(diagram: unknown, changes = false): Inner<NativeSphericalDiagram> {
  const inner = innerOf(diagram, changes);
  if (inner.space !== sphere) throw wrongReceiver(diagram);
  return inner as Inner<NativeSphericalDiagram>;
}

const radiusOf = (native: AnyNative) => (native as NativeSphericalDiagram).radius();

export const sphere: Space = {
  names: ["lon", "lat", "r"],
  sites: "lonLatR",
  points: "lonLat",
  error: (name, axis, value, native) => errorOf(name, axis, value, radiusOf(native)),
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

/** In radians, of what is given in the unit of the radius. */
export function checkedTolerance(
  options: { tolerance?: unknown } | undefined,
  radius: number,
): number {
  const tolerance = options?.tolerance;
  if (tolerance === undefined) return kTolerance;
  if (typeof tolerance !== "number" || !Number.isFinite(tolerance))
    throw notFinite("options.tolerance", tolerance);
  const angle = tolerance / radius;
  // 1e-9 times the radius is accepted, whichever way it was rounded.
  if (angle >= kFinestTolerance * (1 - 2 * Number.EPSILON))
    return Math.max(angle, kFinestTolerance);
  throw new ApolloniusError(
    "out-of-range",
    `options.tolerance is ${tolerance}, expected at least 1e-9 of the radius, which is ${radius}`,
  );
}

// --- Items ---------------------------------------------------------------------------------------

type Fields = { readonly [name: string]: unknown } & ArrayLike<unknown>;

/** Longitude, latitude and weight of an item without accessors; undefined if it is none. */
function fields(item: unknown): [lon: unknown, lat: unknown, r: unknown] | undefined {
  if (typeof item !== "object" || item === null) return undefined;
  const own = item as Fields;
  if (Array.isArray(item) || ArrayBuffer.isView(item)) return [own[0], own[1], own[2]];
  const geometry = (own.type === "Feature" ? own.geometry : own) as Fields | null;
  if (geometry?.type === "Point" && isArrayLike(geometry.coordinates))
    return [geometry.coordinates[0], geometry.coordinates[1], undefined];
  return "lon" in own && "lat" in own ? [own.lon, own.lat, own.r] : undefined;
}

/** Items of a diagram on a sphere of this radius. */
export const places = (radius: number): ItemKind => ({
  names: sphere.names,
  sites: sphere.sites,
  points: sphere.points,
  expected: "{lon, lat, r}, [lon, lat, r] or a GeoJSON point",
  fields,
  error: (name, axis, value) => errorOf(name, axis, value, radius),
});

/** The items of `SphericalDiagram.from`, of which a FeatureCollection has a list. */
export function itemsOf(given: unknown): Items<unknown> {
  const collection = given as { type?: unknown; features?: unknown } | null;
  const isCollection = collection?.type === "FeatureCollection";
  return (isCollection ? collection.features : given) as Items<unknown>;
}
