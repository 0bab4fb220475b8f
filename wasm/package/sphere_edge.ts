// The same entry where nothing may be compiled, as edge.ts is of the default one.
import compiled from "../../build/wasm/sphere.wasm?module";
import { setSphereSource } from "./native/module.js";

export * from "./sphere/sphere_api.js";

setSphereSource(() => compiled);
