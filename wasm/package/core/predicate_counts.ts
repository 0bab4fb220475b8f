import { runningModule } from "./native/module.js";
import type { PredicateCounts } from "./types.js";

/**
 * How often each stage of the predicates has answered, for all diagrams since the module was
 * started (this call starts it if nothing has). The difference of two calls is what was asked in
 * between. Cost: O(1). Throws "not-loaded" as the first diagram does.
 */
export function predicateCounts(): PredicateCounts {
  return runningModule().predicateCounts();
}
