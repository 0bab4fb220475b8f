// The calls of SphericalDiagram: what they are given is checked, and an error names the culprit.
import {
  allocated,
  checkedChoice,
  checkedCount,
  checkedIds,
  checkOptions,
  checkSiteId,
  unknownSite,
} from "../core/arguments.js";
import {
  checkedFilter,
  filterOf,
  type Filters,
  findMany as findManyOf,
  firstOf,
  type Found,
  passing,
} from "../core/filters.js";
import {
  type NativeSphericalDiagram,
  runningModule,
  type SphericalNearestFirst,
} from "../core/native/module.js";
import { checkedMaxDistance, orInfinity } from "../core/queries.js";
import type { FilterOptions, FindManyArguments, NearbyOptions, Position } from "../core/types.js";
import { ApolloniusError } from "../errors.js";
import { checkedProperties, checkedWinding, featuresOf, positionsOf } from "../shapes/geojson.js";
import {
  checkedAngularTolerance,
  checkedPoints,
  checkedSites,
  checkPoint,
  checkSite,
} from "./spherical_arguments.js";
import type {
  ListedSphericalSite,
  SphericalCollection,
  SphericalGeoJSONOptions,
  SphericalPolygonOptions,
  SphericalSites,
} from "./spherical_types.js";

/** The same diagram, of which this is a site. */
export function withSite(native: NativeSphericalDiagram, id: number): NativeSphericalDiagram {
  checkSiteId(id);
  if (!native.has(id)) throw unknownSite(id);
  return native;
}

// --- Sites ---------------------------------------------------------------------------------------

export function insertMany(
  native: NativeSphericalDiagram,
  lonLatR: ArrayLike<number>,
): Uint32Array {
  const numbers = checkedSites("lonLatR", lonLatR, native.radius());
  const ids = allocated(() => new Uint32Array(numbers.length / 3));
  native.insertMany(numbers, ids);
  return ids;
}

export function update(
  native: NativeSphericalDiagram,
  id: number,
  lon: number,
  lat: number,
  r: number | undefined,
): void {
  const weight = r === undefined ? withSite(native, id).site(id).r : r;
  checkSite(lon, lat, weight, native.radius());
  withSite(native, id).update(id, lon, lat, weight);
}

export function updateMany(
  native: NativeSphericalDiagram,
  ids: ArrayLike<number>,
  lonLatR: ArrayLike<number>,
): void {
  const sites = checkedIds("ids", ids);
  const numbers = checkedSites("lonLatR", lonLatR, native.radius());
  if (numbers.length !== 3 * sites.length)
    throw new ApolloniusError(
      "bad-length",
      `expected ${3 * sites.length} values in lonLatR for ${sites.length} ids, got ` +
        numbers.length,
    );
  const unknown = sites.findIndex((id) => !native.has(id));
  if (unknown !== -1)
    throw new ApolloniusError(
      "unknown-site",
      `ids[${unknown}]: ${unknownSite(ids[unknown]).message}`,
    );
  native.updateMany(sites, numbers);
}

/** The sites one by one. */
export function* listedSites({
  ids,
  lonLatR,
  hidden,
}: SphericalSites): Generator<ListedSphericalSite, void> {
  for (let k = 0; k < ids.length; ++k) {
    const [lon, lat, r] = [lonLatR[3 * k]!, lonLatR[3 * k + 1]!, lonLatR[3 * k + 2]!];
    yield { id: ids[k]!, lon, lat, r, hidden: hidden[k] === 1 };
  }
}

// --- Queries -------------------------------------------------------------------------------------

function walkFrom(
  native: NativeSphericalDiagram,
  lon: number,
  lat: number,
  farthest: number,
): SphericalNearestFirst {
  return native.nearestFirst(lon, lat, farthest) as SphericalNearestFirst;
}

/** As nearest, without the distance, which costs as much as the search. */
export function find(
  native: NativeSphericalDiagram,
  filters: Filters,
  lon: number,
  lat: number,
  options: FilterOptions | undefined,
): number {
  if (options !== undefined) return nearest(native, filters, lon, lat, options)?.id ?? -1;
  checkPoint(lon, lat);
  return native.find(lon, lat);
}

export function nearest(
  native: NativeSphericalDiagram,
  filters: Filters,
  lon: number,
  lat: number,
  options: FilterOptions | undefined,
): Found | null {
  checkPoint(lon, lat);
  const filter = filterOf(options);
  if (filter !== undefined) return passing(walkFrom(native, lon, lat, Infinity), filter, filters);
  const found = native.nearest(lon, lat);
  return found.id === -1 ? null : found;
}

function findAll(
  native: NativeSphericalDiagram,
  numbers: ArrayLike<number>,
  distances?: Float64Array,
): Int32Array {
  const ids = allocated(() => new Int32Array(numbers.length / 2));
  native.findMany(numbers, ids, distances ?? null);
  return ids;
}

export function findMany(
  native: NativeSphericalDiagram,
  filters: Filters,
  lonLat: ArrayLike<number>,
  how: FindManyArguments,
): Int32Array {
  return findManyOf(native, filters, checkedPoints("lonLat", lonLat), how, {
    all: findAll,
    one: (lon, lat, filter) => passing(walkFrom(native, lon, lat, Infinity), filter, filters),
    empty: () => runningModule().createSpherical(native.radius()),
  });
}

function nearby(
  native: NativeSphericalDiagram,
  filters: Filters,
  [lon, lat]: Position,
  most: number,
  farthest: number,
  filter: unknown,
): Uint32Array {
  const checked = checkedFilter(filter);
  if (checked === undefined) return native.kNearest(lon, lat, most, farthest);
  return firstOf(walkFrom(native, lon, lat, farthest), most, checked, filters);
}

export function kNearest(
  native: NativeSphericalDiagram,
  filters: Filters,
  lon: number,
  lat: number,
  k: number,
  options: NearbyOptions | undefined,
): Uint32Array {
  checkPoint(lon, lat);
  const most = checkedCount("k", k);
  checkOptions(options, "maxDistance", "filter");
  const farthest = checkedMaxDistance("options.maxDistance", orInfinity(options?.maxDistance));
  return nearby(native, filters, [lon, lat], most, farthest, options?.filter);
}

export function within(
  native: NativeSphericalDiagram,
  filters: Filters,
  lon: number,
  lat: number,
  distance: number,
  options: FilterOptions | undefined,
): Uint32Array {
  checkPoint(lon, lat);
  const farthest = checkedMaxDistance("distance", distance);
  checkOptions(options, "filter");
  const most = checkedCount("k", Infinity);
  return nearby(native, filters, [lon, lat], most, farthest, options?.filter);
}

// --- Cells ---------------------------------------------------------------------------------------

export function cellPolygon(
  native: NativeSphericalDiagram,
  id: number,
  options: SphericalPolygonOptions | undefined,
): Position[] | null {
  checkOptions(options, "tolerance", "winding");
  const winding = checkedWinding(options?.winding);
  const tolerance = checkedAngularTolerance(options?.tolerance);
  if (native.isHidden(id)) return null;
  const ring = positionsOf(native.cellPolygon(id, tolerance, false).coordinates);
  return winding === "clockwise" ? ring.reverse() : ring;
}

/** `living` is asked last, as the caller's options can dispose of the diagram before. */
export function toGeoJSON<Properties>(
  living: () => NativeSphericalDiagram,
  options: SphericalGeoJSONOptions<Properties> | undefined,
): SphericalCollection<Properties> {
  checkOptions(options, "tolerance", "properties", "winding", "antimeridian");
  const properties = checkedProperties<Properties>(options?.properties);
  const winding = checkedWinding(options?.winding);
  const antimeridian = checkedChoice<"cut" | "keep">(
    "options.antimeridian",
    options?.antimeridian,
    winding === "clockwise" ? ["keep", "cut"] : ["cut", "keep"],
  );
  const tolerance = checkedAngularTolerance(options?.tolerance);
  const polygons = living().cellPolygons(tolerance, antimeridian === "cut");
  const collection = featuresOf(polygons, properties, winding);
  if (polygons.parts.length > 1) return collection;
  // The only visible site's, which is the whole sphere.
  const features = collection.features.map((feature) => ({
    ...feature,
    geometry: { type: "Sphere" as const },
  }));
  return { type: collection.type, features };
}
