// What both variants of the entry `apollonius-diagram/sphere` export.
export { ApolloniusError, type ErrorCode } from "../errors.js";
export { SphericalDiagram } from "./spherical_diagram.js";
export type {
  GeoJSONPoint,
  ListedSphericalSite,
  Spherical,
  SphericalCollection,
  SphericalGeoJSONOptions,
  SphericalOptions,
  SphericalPolygonOptions,
  SphericalSite,
  SphericalSites,
  SphericalVertices,
} from "./spherical_types.js";
export type { Accessor, Items } from "../accessors.js";
export type {
  Edges,
  FilterOptions,
  FindManyArguments,
  NearbyFilter,
  NearbyOptions,
  Position,
} from "../types.js";
