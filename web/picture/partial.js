// The diagram that some of the sites would have without the others.
import { Diagram } from "apollonius-diagram";
import { boundsOf, drawOptions, ScreenStrokes } from "./curves.js";

/**
 * Strokes its edges.
 * @param {CanvasRenderingContext2D} context
 * @param {{ sites: import("../model/sites.js").Sites, view: import("./view.js").View }} picture
 * @param {import("./view.js").Box} box @param {ArrayLike<number>} ids
 */
export function strokePartial(context, { sites, view }, box, ids) {
  const bounds = boundsOf(view, box);
  if (!bounds) return;
  const diagram = new Diagram(sites.countingTriples(ids));
  const strokes = new ScreenStrokes(context, view, box);
  diagram.voronoi(bounds).render(strokes, drawOptions(view));
  strokes.finish();
  diagram.dispose();
}
