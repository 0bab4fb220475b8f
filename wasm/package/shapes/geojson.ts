// Cells as GeoJSON (RFC 7946).
import type { CoverageArrays } from "../../../build/wasm/apollonius.mjs";
import { checkedChoice, described } from "../core/arguments.js";
import type { Position } from "../core/types.js";
import { ApolloniusError } from "../errors.js";

/** Options of `cellGeometry`. */
export interface GeometryOptions {
  /** As in `DrawOptions`. */
  tolerance?: number | undefined;
  /**
   * How outer rings run, y upwards, and holes the other way round: "counter-clockwise" (default),
   * as RFC 7946 has it; "clockwise" for tools that work on the sphere, such as d3-geo, to which a
   * ring the other way round is everything but the cell.
   */
  winding?: Winding | undefined;
}

/** Options of `toGeoJSON`. */
export interface GeoJSONOptions<Properties> extends GeometryOptions {
  /** Gives the properties of a site's feature; by default they are { site: id }. */
  properties?: ((id: number) => Properties) | undefined;
}

/** Options of `toGeoJSON` for one feature a group of sites. */
export interface GroupOptions<Key, Properties> extends GeometryOptions {
  /**
   * Gives the key of a site's group, anything that a Map takes: sites with one key have one
   * feature. A site with undefined has none.
   */
  group: (id: number) => Key | undefined;
  /** Gives the properties of a group's feature; by default they are { group: key }. */
  properties?: ((key: Key) => Properties) | undefined;
}

/** A cell as a geometry of GeoJSON. */
export type CellGeometry =
  | { type: "Polygon"; coordinates: Position[][] }
  | { type: "MultiPolygon"; coordinates: Position[][][] };

/** The borders between cells as a geometry of GeoJSON, a line for each edge. */
export interface CellMesh {
  /** GeoJSON's name of it. */
  type: "MultiLineString";
  /** The points of each line. */
  coordinates: Position[][];
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
    geometry: CellGeometry;
  }[];
}

/** GeoJSON (RFC 7946) of groups of cells. */
export interface GroupsCollection<Key, Properties = { group: Key }> {
  /** GeoJSON's name of it. */
  type: "FeatureCollection";
  /** One feature a group that has a part in the window, in the order of their first sites. */
  features: {
    type: "Feature";
    /** The key, if it is a string or a finite number. */
    id?: Key & (string | number);
    properties: Properties;
    geometry: CellGeometry;
  }[];
}

/** Pairs of a flat ring, or of the one with points `first` to before `end` of several. */
export function positionsOf(rings: Float64Array, first = 0, end = rings.length / 2): Position[] {
  const positions = new Array<Position>(end - first);
  for (let k = first; k < end; ++k) positions[k - first] = [rings[2 * k]!, rings[2 * k + 1]!];
  return positions;
}

/** How rings run. */
export type Winding = "counter-clockwise" | "clockwise";

function checkedFunction(name: string, value: unknown, of: string) {
  if (typeof value === "function") return;
  throw new ApolloniusError(
    "bad-option",
    `options.${name} is ${described(value)}, expected a function of ${of}`,
  );
}

/** Throws "bad-option". */
export function checkedProperties<Properties>(
  properties: unknown = (id: number) => ({ site: id }),
): (id: number) => Properties {
  checkedFunction("properties", properties, "an id");
  return properties as (id: number) => Properties;
}

/** Groups of sites, and their keys by their numbers. */
export interface Groups<Key, Properties> {
  keys: Key[];
  /** The number of a group by id; kNoGroup of C++ for none. */
  numbers: Uint32Array;
  properties: (key: Key) => Properties;
}

/** Asks for the group of each of these sites, whose ids are ascending. Throws "bad-option". */
export function groupsOf<Key, Properties>(
  ids: Uint32Array,
  { group, properties = (key) => ({ group: key }) as Properties }: GroupOptions<Key, Properties>,
): Groups<Key, Properties> {
  checkedFunction("group", group, "an id");
  checkedFunction("properties", properties, "a key");
  const numberOf = new Map<Key, number>();
  const numbers = new Uint32Array((ids.at(-1) ?? -1) + 1).fill(-1);
  for (const id of ids) {
    const key = group(id);
    if (key === undefined) continue;
    const number = numberOf.get(key) ?? numberOf.size;
    numberOf.set(key, number);
    numbers[id] = number;
  }
  return { keys: [...numberOf.keys()], numbers, properties };
}

export function checkedWinding(winding: unknown): Winding {
  return checkedChoice("options.winding", winding, ["counter-clockwise", "clockwise"]);
}

/** @internal The k-th of several cells. */
export function geometryOf(
  { coordinates, starts, parts, cells }: CoverageArrays,
  k: number,
  winding: Winding,
): CellGeometry {
  // Loops, as most lists have one item, for which `Array.from` takes far longer.
  const polygons: Position[][][] = [];
  for (let part = cells[k]!; part < cells[k + 1]!; ++part) {
    const rings: Position[][] = [];
    for (let n = parts[part]!; n < parts[part + 1]!; ++n) {
      const ring = positionsOf(coordinates, starts[n], starts[n + 1]);
      rings.push(winding === "clockwise" ? ring.reverse() : ring);
    }
    polygons.push(rings);
  }
  return polygons.length === 1
    ? { type: "Polygon", coordinates: polygons[0] as Position[][] }
    : { type: "MultiPolygon", coordinates: polygons };
}

/** @internal One feature a cell. */
export function featuresOf<Properties>(
  polygons: CoverageArrays,
  properties: (id: number) => Properties,
  winding: Winding,
): CellsCollection<Properties> {
  const features = Array.from(polygons.sites, (id, k) => {
    const geometry = geometryOf(polygons, k, winding);
    return { type: "Feature" as const, id, properties: properties(id), geometry };
  });
  return { type: "FeatureCollection", features };
}

/** @internal One feature a group. Not `featuresOf`, which the sphere's users download, too. */
export function groupFeaturesOf<Key, Properties>(
  polygons: CoverageArrays,
  { keys, properties }: Groups<Key, Properties>,
  winding: Winding,
): GroupsCollection<Key, Properties> {
  const features = Array.from(polygons.sites, (number, k) => {
    const key = keys[number]!;
    const isId = typeof key === "string" || Number.isFinite(key);
    const id = isId ? { id: key as Key & (string | number) } : {};
    const geometry = geometryOf(polygons, k, winding);
    return { type: "Feature" as const, ...id, properties: properties(key), geometry };
  });
  return { type: "FeatureCollection", features };
}

/** @internal What is a side of two cells, which have its points in common; a line for each edge. */
export function meshOf({ coordinates, starts, parts, cells }: CoverageArrays): CellMesh {
  const keyOf = (...ends: [from: number, to: number]) =>
    ends.map((k) => `${coordinates[2 * k]},${coordinates[2 * k + 1]}`).join();
  const owners = new Map<string, number>(); // cells, by their sides
  const visitRings = (visit: (cell: number, first: number, last: number) => void) => {
    for (let cell = 0; cell + 1 < cells.length; ++cell)
      for (let ring = parts[cells[cell]!]!; ring < parts[cells[cell + 1]!]!; ++ring)
        visit(cell, starts[ring]!, starts[ring + 1]! - 1);
  };
  visitRings((cell, first, last) => {
    for (let k = first; k < last; ++k) owners.set(keyOf(k, k + 1), cell);
  });
  const lines: Position[][] = [];
  visitRings((cell, first, last) => {
    // By side, the cell beyond it, if that comes later.
    const beyond = Array.from({ length: last - first }, (_, k) => {
      const other = owners.get(keyOf(first + k + 1, first + k));
      return other !== undefined && other > cell ? other : -1;
    });
    // An edge may go on where the ring is closed.
    const start = Math.max(
      beyond.findIndex((other, k) => other !== beyond.at(k - 1)),
      0,
    );
    let before = -1;
    for (let n = 0; n < beyond.length; ++n) {
      const k = (start + n) % beyond.length;
      const other = beyond[k]!;
      if (other !== -1) {
        const side = positionsOf(coordinates, first + k, first + k + 2);
        if (other === before) lines.at(-1)!.push(side[1]!);
        else lines.push(side);
      }
      before = other;
    }
  });
  return { type: "MultiLineString", coordinates: lines };
}
