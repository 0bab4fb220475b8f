// `apollonius-diagram/treemap` where nothing may be compiled, as core_edge.ts is of core.ts.
import "./shapes_edge.js";

export { load } from "./core_edge.js";
export * from "./treemap/api.js";
export { ApolloniusError, type ErrorCode } from "./errors.js";
