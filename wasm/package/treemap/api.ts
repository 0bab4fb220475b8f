// Exports of the entry `apollonius-diagram/treemap`, whichever way the wasm comes.
export { treemap } from "./layout.js";
export type {
  Disc,
  Treemap,
  AsyncTreemapOptions,
  TreemapCell,
  TreemapFit,
  TreemapNode,
  TreemapOptions,
  TreemapShape,
  WithCells,
} from "./types.js";
export type { DrawOptions, PathContext } from "../core/path.js";
export type { GeoJSONRegion, Region, Ring } from "../shapes/region.js";
export type { CellCircle, CellCircleOptions } from "../shapes/types.js";
export type { AsyncOptions, Bounds, Position, Site } from "../core/types.js";
