// Exports of the entry `apollonius-diagram/sphere`, whichever way the wasm comes.
export { SphericalDiagram } from "./spherical_diagram.js";
export type { SphericalVoronoi } from "./spherical_voronoi.js";
export type {
  CutAtAntimeridian,
  GeoJSONPoint,
  ListedSphericalSite,
  Spherical,
  SphericalBuildOptions,
  SphericalCellCircle,
  SphericalCollection,
  SphericalEdgesWithClearance,
  SphericalEmptyCircle,
  SphericalGeoJSONOptions,
  SphericalGeometry,
  SphericalGeometryOptions,
  SphericalMeasures,
  SphericalOptions,
  SphericalPolygonOptions,
  SphericalSite,
  SphericalSites,
  SphericalTriangulation,
  SphericalVertices,
} from "./spherical_types.js";
export type { CellGeometry, CellMesh, CellsCollection, Winding } from "../shapes/geojson.js";
export type {
  AsyncInterpolationOptions,
  CellPolygon,
  CellRing,
  EdgeOptions,
  InterpolationOptions,
  MaxDistance,
  NaturalWeights,
  NumbersById,
  ViewOptions,
} from "../shapes/types.js";
export type { Accessor, Items } from "../core/accessors.js";
export type {
  AsyncOptions,
  Edges,
  FilterOptions,
  FindOptions,
  FoundSite,
  KNearestManyOptions,
  NearbyLists,
  NearestSites,
  PickOptions,
  Position,
  RadiusOption,
  UpdateOptions,
  WithinManyOptions,
} from "../core/types.js";
