// The types of apollonius-diagram/sphere that users see.
import type { AsyncOptions, Edges, Position, RadiusOption } from "../core/types.js";
import type { CellGeometry, Winding } from "../shapes/geojson.js";

/** A site of the sphere: its centre in degrees, its weight in the unit of the radius. */
export interface SphericalSite {
  /** Longitude of the centre, as given. */
  lon: number;
  /** Latitude of the centre. */
  lat: number;
  /** Weight: how far from the centre the distance is 0; a head start. */
  r: number;
}

/** A site as a loop over the diagram finds it. */
export interface ListedSphericalSite extends SphericalSite {
  /** Id of the site. */
  id: number;
  /** Whether its cell is empty, because another site covers it. */
  hidden: boolean;
}

/**
 * All sites, ascending by id; row k of each array belongs to the k-th of them. `lonLatR` is what
 * `new SphericalDiagram`, `insertMany` and `updateMany(ids, lonLatR)` take.
 */
export interface SphericalSites {
  /** The ids. */
  ids: Uint32Array;
  /** Longitude, latitude, r of each site, exactly as given. */
  lonLatR: Float64Array;
  /** 1 for a hidden site, 0 for one with a cell. */
  hidden: Uint8Array;
}

/** The Voronoi vertices of the sphere; row k of each array belongs to vertex k. */
export interface SphericalVertices {
  /** Longitude, latitude of each vertex, in degrees. */
  lonLat: Float64Array;
  /** Common distance to its three sites. */
  clearance: Float64Array;
  /** The three sites, counter-clockwise as seen from outside. */
  sites: Uint32Array;
}

/**
 * The Delaunay graph of the sphere as it was when `diagram.triangulation()` was called. Triangle t
 * has the half-edges 3 t, 3 t + 1 and 3 t + 2, and is row t of `diagram.vertices()`, as the diagram
 * was then. Two sites can have several edges in common, so an edge is its half-edge.
 */
export interface SphericalTriangulation {
  /** Longitude, latitude of each site by id, as given, hidden ones too; NaN for ids without one. */
  readonly points: Float64Array;
  /** The ids of each triangle's sites, counter-clockwise as seen from outside. */
  readonly triangles: Uint32Array;
  /** The twin of each half-edge, in the triangle on its other side; every one has a twin. */
  readonly halfedges: Int32Array;
  /** Empty: the graph has no border. */
  readonly hull: Uint32Array;
}

/** `edges({ clearance: true })`; row k of each array belongs to edge k. */
export interface SphericalEdgesWithClearance extends Edges {
  /** The smallest distance of each edge to its two sites. */
  clearance: Float64Array;
  /** Longitude, latitude of the place on each edge where that is. */
  lonLat: Float64Array;
}

/** A circle on the sphere that no site reaches into. */
export interface SphericalEmptyCircle {
  /** Longitude of its centre. */
  lon: number;
  /** Latitude of its centre. */
  lat: number;
  /** The distance to the nearest site; below 0 where the whole sphere is covered. */
  r: number;
  /** The id of a site at that distance. */
  site: number;
}

/** The largest circle inside a cell. */
export interface SphericalCellCircle {
  /** Longitude of its centre. */
  lon: number;
  /** Latitude of its centre. */
  lat: number;
  /** Its radius; of the whole sphere half a great circle. */
  r: number;
}

/** Options of `SphericalDiagram`. */
export interface SphericalOptions extends RadiusOption {
  /**
   * The radius of the sphere, > 0, in the unit of weights and distances. Default: 1, which makes
   * them radians; 6371.0088 makes them kilometres on the Earth.
   */
  radius?: number | undefined;
}

/** Options of `SphericalDiagram.fromAsync`. */
export interface SphericalBuildOptions extends SphericalOptions, AsyncOptions {}

/** Items that `SphericalDiagram.from` reads without accessors; of GeoJSON, points. */
export type Spherical =
  | { readonly lon: number; readonly lat: number; readonly r?: number | undefined }
  | GeoJSONPoint
  | ArrayLike<number>;

/** A point of GeoJSON, or a feature that has one. */
export type GeoJSONPoint =
  | { readonly type: "Point"; readonly coordinates: readonly number[] }
  | {
      readonly type: "Feature";
      readonly geometry: { readonly type: "Point"; readonly coordinates: readonly number[] };
    };

/** Options of `SphericalVoronoi.cellPolygon` and `cellPolygons`. */
export interface SphericalPolygonOptions {
  /**
   * How far a polygon may be from its cell, in the unit of the radius; at least 1e-9 of that.
   * Default: 1e-4 of it, on the Earth 640 m.
   */
  tolerance?: number | undefined;
  /**
   * How a ring runs, as seen from outside: "counter-clockwise" (default), or "clockwise", as d3-geo
   * has it.
   */
  winding?: Winding | undefined;
}

/** Options of `SphericalVoronoi.cellGeometry`. */
export interface SphericalGeometryOptions extends SphericalPolygonOptions {
  /**
   * "cut": cells are cut at the meridian of 180° and closed along it and the poles, as RFC 7946 has
   * it, for tools that take longitude and latitude for a plane; points are joined by straight lines
   * there. "keep": one ring each, joined by arcs of great circles, for tools that know the sphere.
   * Default: "cut", or for winding "clockwise" "keep".
   */
  antimeridian?: "cut" | "keep" | undefined;
}

/** Options of `SphericalVoronoi.toGeoJSON`. */
export interface SphericalGeoJSONOptions<Properties> extends SphericalGeometryOptions {
  /** Gives the properties of a site's feature; by default they are { site: id }. */
  properties?: ((id: number) => Properties) | undefined;
}

/** Options with which no cell is d3-geo's Sphere. */
export interface CutAtAntimeridian {
  /** As RFC 7946 has it. */
  winding?: "counter-clockwise" | undefined;
  /** As RFC 7946 has it. */
  antimeridian?: "cut" | undefined;
}

/** A cell as a geometry: GeoJSON's, or d3-geo's of the whole sphere. */
export type SphericalGeometry = CellGeometry | { type: "Sphere" };

/** Measures of a cell, in the unit of the radius. */
export interface SphericalMeasures {
  /** Area, in the square of that unit; 0 without a cell. */
  area: number;
  /** Longitude and latitude, as `cellCentroid`; null without a cell. */
  centroid: Position | null;
  /** Length of the boundary; 0 without a cell. */
  perimeter: number;
}

/**
 * GeoJSON of cells. A cell that is the whole sphere is, unless it is cut, d3-geo's `{ type:
 * "Sphere" }`.
 */
export interface SphericalCollection<Properties = { site: number }> {
  /** GeoJSON's name of it. */
  type: "FeatureCollection";
  /** One feature a cell. */
  features: { type: "Feature"; id: number; properties: Properties; geometry: SphericalGeometry }[];
}
