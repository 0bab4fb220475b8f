// The diagram that some of the sites would have without the others.
import { Diagram } from "apollonius-diagram";
import type { Sites } from "../model/sites.js";
import { boundsOf, drawOptions, ScreenStrokes } from "./curves.js";
import type { Box, View } from "./view.js";

/** Strokes its edges. */
export function strokePartial(
  context: CanvasRenderingContext2D,
  { sites, view }: { sites: Sites; view: View },
  box: Box,
  ids: ArrayLike<number>,
) {
  const bounds = boundsOf(view, box);
  if (!bounds) return;
  const diagram = new Diagram(sites.countingTriples(ids));
  const strokes = new ScreenStrokes(context, view, box);
  diagram.voronoi(bounds).render(strokes, drawOptions(view));
  strokes.finish();
  diagram.dispose();
}
