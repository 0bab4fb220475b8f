// The names of shapes that the entries `apollonius-diagram` and `apollonius-diagram/shapes` share.
export { curvePoint, curveTangent } from "./curves.js";
export type { CellsCollection, GeoJSONOptions } from "./geojson.js";
export type { GeoJSONRegion, Region, Ring } from "./region.js";
export type {
  AreaTargets,
  AsyncFitOptions,
  AsyncInterpolationOptions,
  CellCircle,
  CellCircleOptions,
  CellCurves,
  CellPart,
  CellPolygon,
  CellRing,
  DualOptions,
  EdgeCurves,
  EdgeOptions,
  EdgesWithClearance,
  EmptyCircle,
  EmptyCircleOptions,
  EnclosingCircle,
  FitOptions,
  FitProgress,
  FittedAreas,
  FlatOptions,
  InterpolationOptions,
  Measures,
  NaturalWeights,
  NestedOptions,
  NumbersById,
  PolygonOptions,
  Projection,
  VerticesInside,
  VoronoiOptions,
  VoronoiWindow,
} from "./types.js";
export { Voronoi } from "./voronoi.js";
