// The exports of the entry `apollonius-diagram/core`, however the wasm is loaded.
export type {
  Accessor,
  Circular,
  Items,
} from "./accessors.js";
export { Diagram } from "./diagram.js";
export type { DrawOptions, PathContext } from "./path.js";
export type { Triangulation } from "./triangulation.js";
export type {
  AsyncOptions,
  AsyncSnapshotOptions,
  Bounds,
  BuildOptions,
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
  RadiusOption,
  Site,
  Sites,
  SnapshotOptions,
  UpdateOptions,
  Vertices,
  WithinManyOptions,
} from "./types.js";
export { ApolloniusError, type ErrorCode } from "../errors.js";
