// Tells when the canvases and the panels show the state that the page is in.
import type { App } from "./app.js";
import { isUpToDate } from "./ui/dom.js";

/**
 * Resolves in the first frame after which nothing is left to draw or to write; never while
 * something moves by itself.
 */
export async function whenShown(app: App) {
  do await new Promise(requestAnimationFrame);
  while (!app.painter.isDone || !isUpToDate());
}
