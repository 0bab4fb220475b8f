// The file for a script tag: the default entry as the global `apollonius`.
import * as apollonius from "./embedded.js";

Object.assign(globalThis, { apollonius });
