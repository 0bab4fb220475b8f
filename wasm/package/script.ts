// The file for a script tag: the default entry, the sphere and the treemap as the global
// `apollonius`. Each part of the wasm is decoded and compiled at its first use.
import * as apollonius from "./embedded.js";
import * as sphere from "./sphere.js";
import * as treemap from "./treemap.js";

Object.assign(globalThis, { apollonius: { ...sphere, ...treemap, ...apollonius } });
