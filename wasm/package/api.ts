// What both entries of the package export.
export type {
  Accessor,
  Accessors,
  AsyncAccessors,
  Circular,
  Items,
  SomeAccessors,
  SomeAsync,
} from "./accessors.js";
export { Diagram } from "./diagram.js";
export type {
  AreaTargets,
  AsyncFitOptions,
  BuildOptions,
  DiagramOptions,
  Edges,
  FilterOptions,
  FitOptions,
  FitProgress,
  FittedAreas,
  NearbyFilter,
  NearbyOptions,
  PickOptions,
  PredicateCounts,
  ListedSite,
  Site,
  Sites,
  SnapshotOptions,
  StageCounts,
  Vertices,
} from "./types.js";
export { predicateCounts } from "./predicate_counts.js";
export { ApolloniusError, type ErrorCode } from "./errors.js";
export type { CellsCollection, GeoJSONOptions, Position } from "./geojson.js";
export type { DrawOptions, DualOptions, PathContext } from "./path.js";
export {
  type Bounds,
  type CellCurves,
  type CellPolygon,
  type CellPart,
  type CellRing,
  type EdgeCurves,
  type FlatOptions,
  type Measures,
  type NestedOptions,
  type PolygonOptions,
  Voronoi,
} from "./voronoi.js";
export type { GeoJSONRegion, Region, Ring } from "./region.js";
export { curvePoint, curveTangent } from "./curves.js";
