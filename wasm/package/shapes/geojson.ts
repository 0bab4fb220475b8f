// Cells as GeoJSON (RFC 7946).
import type { CoverageArrays } from "../../../build/wasm/apollonius.mjs";
import { checkedChoice, checkOptions, described } from "../core/arguments.js";
import type { Position } from "../core/types.js";
import { ApolloniusError } from "../errors.js";

/** Options of `toGeoJSON`. */
export interface GeoJSONOptions<Properties> {
  /** As in `DrawOptions`. */
  tolerance?: number | undefined;
  /** Gives the properties of a site's feature; by default they are { site: id }. */
  properties?: ((id: number) => Properties) | undefined;
  /**
   * How outer rings run, y upwards, and holes the other way round: "counter-clockwise" (default),
   * as RFC 7946 has it; "clockwise" for tools that work on the sphere, such as d3-geo, to which a
   * ring the other way round is everything but the cell.
   */
  winding?: Winding | undefined;
}

/** GeoJSON (RFC 7946) of cells; the id of each feature is its site's. */
export interface CellsCollection<Properties = { site: number }> {
  /** GeoJSON's name of it. */
  type: "FeatureCollection";
  /** One feature a cell. */
  features: {
    type: "Feature";
    id: number;
    properties: Properties;
    geometry:
      | { type: "Polygon"; coordinates: Position[][] }
      | { type: "MultiPolygon"; coordinates: Position[][][] };
  }[];
}

/** Pairs of a flat ring, or of the one with points `first` to before `end` of several. */
export function positionsOf(rings: Float64Array, first = 0, end = rings.length / 2): Position[] {
  const positions: Position[] = [];
  for (let k = 2 * first; k < 2 * end; k += 2) positions.push([rings[k]!, rings[k + 1]!]);
  return positions;
}

/** How rings run. */
export type Winding = "counter-clockwise" | "clockwise";

/** Throws "bad-option". */
export function checkedProperties<Properties>(
  properties: unknown = (id: number) => ({ site: id }),
): (id: number) => Properties {
  if (typeof properties === "function") return properties as (id: number) => Properties;
  throw new ApolloniusError(
    "bad-option",
    `options.properties is ${described(properties)}, expected a function of an id`,
  );
}

export function checkedWinding(winding: unknown): Winding {
  return checkedChoice("options.winding", winding, ["counter-clockwise", "clockwise"]);
}

/** @internal `polygonsOf` gives those of all cells, within a tolerance. */
export function collectionOf<Properties>(
  polygonsOf: (tolerance: number | undefined) => CoverageArrays,
  options: GeoJSONOptions<Properties> | undefined,
): CellsCollection<Properties> {
  checkOptions(options, "tolerance", "properties", "winding");
  const properties = checkedProperties<Properties>(options?.properties);
  const winding = checkedWinding(options?.winding);
  return featuresOf(polygonsOf(options?.tolerance), properties, winding);
}

/** @internal One feature a cell. */
export function featuresOf<Properties>(
  { coordinates, starts, parts, sites, cells }: CoverageArrays,
  properties: (id: number) => Properties,
  winding: Winding,
): CellsCollection<Properties> {
  const ringAt = (k: number) => {
    const ring = positionsOf(coordinates, starts[k], starts[k + 1]);
    return winding === "clockwise" ? ring.reverse() : ring;
  };
  const partAt = (k: number) =>
    Array.from({ length: parts[k + 1]! - parts[k]! }, (_, n) => ringAt(parts[k]! + n));
  const features = Array.from(sites, (id, k) => {
    const polygons = Array.from({ length: cells[k + 1]! - cells[k]! }, (_, n) =>
      partAt(cells[k]! + n),
    );
    const geometry =
      polygons.length === 1
        ? { type: "Polygon" as const, coordinates: polygons[0] as Position[][] }
        : { type: "MultiPolygon" as const, coordinates: polygons };
    return { type: "Feature" as const, id, properties: properties(id), geometry };
  });
  return { type: "FeatureCollection", features };
}
