// What both entries of the package export.
export type { Accessor } from "./accessors.js";
export { Diagram, type DiagramOptions, type Edges, type Site, type Vertices } from "./diagram.js";
export { ApolloniusError, type ErrorCode } from "./errors.js";
