// The page's state is in signals (@preact/signals-core): who reads one in an effect is told when it
// changes. What happens to the circles is told as events (model.ts): who listens must hear of each
// edit, and in its midst.
import { effect, untracked } from "@preact/signals-core";

export { effect, signal } from "@preact/signals-core";

/**
 * Acts each time that something which `read` reads has changed; not at once. What fails in there
 * does not reach who changed it.
 */
export function whenever(read: () => unknown, act: () => void) {
  let isFirst = true;
  effect(() => {
    read();
    if (!isFirst) untracked(() => attempt(act));
    isFirst = false;
  });
}

function attempt(act: () => void) {
  try {
    act();
  } catch (error) {
    reportError(error);
  }
}
