import { runningModule } from "./native/module.js";
import type { PredicateCounts } from "./types.js";

/**
 * How often each stage of the predicates has answered, for all diagrams since the module began
 * (it does now if nothing was used before). What a call asks is the difference. Cost: O(1). Throws
 * "not-loaded" as the first diagram does.
 */
export function predicateCounts(): PredicateCounts {
  return runningModule().predicateCounts();
}
