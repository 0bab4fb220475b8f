// What both entries of the package export.
import { runningModule } from "./native/module.js";
import type { PredicateCounts } from "./types.js";

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
  Bounds,
  BuildOptions,
  CellCurves,
  CellPart,
  CellPolygon,
  CellRing,
  DiagramOptions,
  EdgeCurves,
  Edges,
  EmptyCircle,
  FilterOptions,
  FindManyArguments,
  FitOptions,
  FitProgress,
  FittedAreas,
  FlatOptions,
  ListedSite,
  Measures,
  NaturalWeights,
  NearbyFilter,
  NearbyOptions,
  NestedOptions,
  NumbersById,
  PickArguments,
  PickOptions,
  PolygonOptions,
  Position,
  PredicateCounts,
  Projection,
  Site,
  Sites,
  SnapshotOptions,
  StageCounts,
  Vertices,
  VoronoiOptions,
  VoronoiWindow,
} from "./types.js";
export { ApolloniusError, type ErrorCode } from "./errors.js";
export type { CellsCollection, GeoJSONOptions } from "./voronoi/geojson.js";
export type { DrawOptions, DualOptions, PathContext } from "./path.js";
export type { Triangulation } from "./triangulation.js";
export { Voronoi } from "./voronoi/voronoi.js";

export type { GeoJSONRegion, Region, Ring } from "./voronoi/region.js";
export { curvePoint, curveTangent } from "./voronoi/curves.js";

/**
 * How often each stage of the predicates has answered, for all diagrams since the module began
 * (it does now if nothing was used before). What a call asks is the difference. Cost: O(1). Throws
 * "not-loaded" as the first diagram does.
 */
export function predicateCounts(): PredicateCounts {
  return runningModule().predicateCounts();
}
