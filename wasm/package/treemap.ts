// The entry `apollonius-diagram/treemap`. It has no wasm of its own: diagrams and errors are those
// of the default entry, which it imports by the package's name (tools/build.mjs).
export { ApolloniusError, type ErrorCode } from "./errors.js";
export { treemap } from "./treemap/layout.js";
export type {
  Disc,
  Treemap,
  TreemapCell,
  TreemapFit,
  TreemapInput,
  TreemapOptions,
  TreemapShape,
} from "./treemap/types.js";
export type { DrawOptions, PathContext } from "./path.js";
export type { GeoJSONRegion, Region, Ring } from "./voronoi/region.js";
export type { Bounds, Position, Site } from "./types.js";
