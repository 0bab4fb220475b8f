// What the entry `apollonius-diagram/core` exports, whichever way the wasm comes.
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
export { predicateCounts } from "./predicate_counts.js";
export type { DrawOptions, PathContext } from "./path.js";
export type { Triangulation } from "./triangulation.js";
export type {
  Bounds,
  BuildOptions,
  DiagramOptions,
  Edges,
  FilterOptions,
  FindOptions,
  FoundSite,
  KNearestManyOptions,
  ListedSite,
  NearbyLists,
  NearestSites,
  PickOptions,
  Position,
  PredicateCounts,
  Site,
  Sites,
  SnapshotOptions,
  StageCounts,
  Vertices,
  WithinManyOptions,
} from "./types.js";
export { ApolloniusError, type ErrorCode } from "../errors.js";
