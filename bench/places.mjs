// The folders of the benchmark's files.
import path from "node:path";
import { root } from "../tools/toolchain/folders.mjs";

export { root };
/** The native programs. */
export const native = path.join(root, "build/bench/bench");
/** The sets of sites and queries. */
export const sets = path.join(root, "build/bench-sets");
/** Committed results; those of quick and partial runs go to `drafts`. */
export const results = path.join(root, "bench/results");
export const drafts = path.join(root, "build/bench-results");
/** The real data set, once fetched. */
export const cities = path.join(root, "build/bench-cities");
