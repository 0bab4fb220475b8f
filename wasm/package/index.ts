// The default entry. As ES modules, these are files of their own, and this one has no code: who
// imports nothing but ApolloniusError gets nothing else, from whatever bundler.
export { ApolloniusError } from "./errors.js";
export * from "./embedded.js";
