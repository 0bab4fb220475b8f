// What the entry `apollonius-diagram/sphere` exports, whichever way the wasm comes.
export { SphericalDiagram } from "./spherical_diagram.js";
export type {
  GeoJSONPoint,
  ListedSphericalSite,
  Spherical,
  SphericalBuildOptions,
  SphericalCollection,
  SphericalEdgesWithClearance,
  SphericalEmptyCircle,
  SphericalGeoJSONOptions,
  SphericalOptions,
  SphericalPolygonOptions,
  SphericalSite,
  SphericalSites,
  SphericalTriangulation,
  SphericalVertices,
} from "./spherical_types.js";
export type {
  DistanceOptions,
  EdgeOptions,
  InterpolationOptions,
  NaturalWeights,
  NumbersById,
} from "../shapes/types.js";
export type { Accessor, Items } from "../core/accessors.js";
export type {
  Edges,
  FilterOptions,
  FindOptions,
  FoundSite,
  KNearestManyOptions,
  NearbyLists,
  NearestSites,
  PickOptions,
  Position,
  WithinManyOptions,
} from "../core/types.js";
