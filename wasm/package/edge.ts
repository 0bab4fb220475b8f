// The default entry where nothing may be compiled, as core_edge.ts is of core.ts.
import "./shapes_edge.js";

export * from "./core_edge.js";
export * from "./shapes/api.js";
export { enclose } from "./shapes/enclose.js";
export { Diagram, type DiagramClass, type Voronoi } from "./shapes/methods.js";
