// The names of shapes that the entries `apollonius-diagram` and `apollonius-diagram/shapes` share.
export { curvePoint, curveTangent } from "./curves.js";
export type {
  CellGeometry,
  CellMesh,
  CellsCollection,
  GeoJSONOptions,
  GeometryOptions,
  Winding,
} from "./geojson.js";
export type { Disc, GeoJSONRegion, Region, Ring, WindowShape } from "./region.js";
export type {
  AreaTargets,
  AsyncFitOptions,
  AsyncInterpolationOptions,
  CellCircle,
  CellCircleOptions,
  CellCurves,
  CellPolygon,
  CellRing,
  DualOptions,
  EdgeCurves,
  EmptyCircle,
  EmptyCircleOptions,
  EnclosingCircle,
  FitOptions,
  FitProgress,
  FittedAreas,
  FlatOptions,
  InterpolationOptions,
  MaxDistance,
  Measures,
  NaturalWeights,
  NestedOptions,
  NumbersById,
  PolygonOptions,
  Projection,
  ViewOptions,
  VoronoiOptions,
  VoronoiWindow,
} from "./types.js";
export type { Voronoi } from "./voronoi.js";
