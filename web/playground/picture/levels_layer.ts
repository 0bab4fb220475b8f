// The hierarchy that finds the nearest site: a ring for each level that a site is on beside the
// diagram itself, and the cells of level 1, which is a diagram of its own.
import { Diagram } from "apollonius-diagram";
import { levels as levelsOf } from "apollonius-diagram/diagnostics";
import type { Sites } from "../model/sites.js";
import { boundsOf, drawOptions, ScreenStrokes } from "./curves.js";
import { addRim } from "./discs.js";
import type { Picture } from "./picture.js";
import type { Box } from "./view.js";

const kMostCells = 5000; // sites of level 1 whose cells are drawn
const kMostRings = 1500; // in the window: more of them are dots
const kRing = 4; // pixels from one ring to the next

export function* drawLevels(context: CanvasRenderingContext2D, picture: Picture, box: Box) {
  const { sites, theme } = picture;
  const levels = upperLevels(sites);
  if (levels.length === 0) return;
  yield;
  context.strokeStyle = theme.level;
  context.fillStyle = theme.level;
  context.lineWidth = 2;
  if (levels[0].length > 1 && levels[0].length <= kMostCells)
    strokeCells(context, picture, box, levels[0]);
  yield;
  context.lineWidth = 1.5;
  for (const [k, ids] of levels.entries()) drawMarks(context, picture, box, ids, k + 1);
}

/** The ids of the sites on each level above the diagram itself, from level 1 on. */
function upperLevels({ ids, diagram }: Sites): number[][] {
  const counts = levelsOf(diagram);
  const levels: number[][] = [];
  for (const id of ids) {
    for (let level = 1; level < counts[id]; level++) {
      levels[level - 1] ??= [];
      levels[level - 1].push(id);
    }
  }
  return levels;
}

/** The cells that these sites have without the others. */
function strokeCells(
  context: CanvasRenderingContext2D,
  { sites, view }: Picture,
  box: Box,
  ids: readonly number[],
) {
  const bounds = boundsOf(view, box);
  if (!bounds) return;
  const diagram = new Diagram(sites.triples(ids));
  const strokes = new ScreenStrokes(context, view, box);
  diagram.voronoi(bounds).render(strokes, drawOptions(view));
  strokes.finish();
  diagram.dispose();
}

function drawMarks(
  context: CanvasRenderingContext2D,
  { sites, view }: Picture,
  box: Box,
  ids: readonly number[],
  level: number,
) {
  const found: [x: number, y: number, r: number][] = [];
  for (const id of ids) {
    const x = view.toScreenX(sites.xyr[3 * id]);
    const y = view.toScreenY(sites.xyr[3 * id + 1]);
    const r = Math.max(sites.site(id).r * view.scale, 0) + kRing * level;
    if (x + r < box.left || x - r > box.right || y + r < box.top || y - r > box.bottom) continue;
    found.push([x, y, r]);
  }
  context.beginPath();
  for (const [x, y, r] of found) {
    if (found.length > kMostRings) {
      context.rect(x - level, y - level, 2 * level, 2 * level);
      continue;
    }
    addRim(context, view, x, y, r);
  }
  if (found.length > kMostRings) context.fill();
  else context.stroke();
}
