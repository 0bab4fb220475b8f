// Tells when the canvases and the panels show the state that the page is in.
import { isUpToDate } from "./ui/dom.js";

/**
 * Resolves in the first frame after which nothing is left to draw or to write; never while
 * something moves by itself.
 * @param {import("./app.js").App} app
 */
export async function whenShown(app) {
  do await new Promise(requestAnimationFrame);
  while (!app.painter.isDone || !isUpToDate());
}
