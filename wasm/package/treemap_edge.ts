// `apollonius-diagram/treemap` where nothing may be compiled, as core_edge.ts is of core.ts.
import "./core_edge.js";
import "./shapes_edge.js";

export * from "./treemap/api.js";
export { ApolloniusError, type ErrorCode } from "./errors.js";
