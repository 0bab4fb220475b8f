// The lines of the diagram: cells, dual graph, hull, vertices with their circles, and the cells of
// the centres alone. Drawn whole or inside a box only, in slices.
import { Diagram, type PathContext } from "apollonius-diagram";
import type { Sites } from "../model/sites.js";
import { addCell, boundsOf, cellCorners, drawOptions, ScreenStrokes } from "./curves.js";
import { addRim } from "./discs.js";
import { drawEdges, type EdgeTarget } from "./edges.js";
import { drawLevels } from "./levels_layer.js";
import type { Picture } from "./picture.js";
import type { Box, View } from "./view.js";

const kCellsGone = 4; // pixels: cells of this size show no lines,
const kCellsWhole = 8; // and from this size on they are as strong as can be
// Lines of smaller cells are one pixel wide, without round ends: that is stroked ten times as fast.
const kFineBelow = 16;
// Asking for all edges in one call costs a fifteenth for each of what asking cell by cell does; but
// it cannot be done in slices.
const kAlwaysWhole = 1500; // visible sites
const kMostWhole = 30_000;
const kCheaper = 15;
const kPlayed = 200; // pieces between pauses
const kMostCompared = 20_000; // sites whose centres get a diagram of their own
const kMostVertices = 4000;
const kMostContoured = 160; // visible sites
const kContour = 14; // pixels from one line of equal distance to the next

/** How strong lines are between cells of this size in pixels. */
const strengthOf = (size: number) =>
  Math.max(0, Math.min(1, (size - kCellsGone) / (kCellsWhole - kCellsGone)));

/**
 * @param size of the cells in the window, in pixels
 * @param expected how many cells meet the box, about
 */
export function* drawLines(
  context: CanvasRenderingContext2D,
  picture: Picture,
  box: Box,
  size: number,
  expected: number,
) {
  const { layers } = picture;
  const near = {
    left: box.left - 3,
    top: box.top - 3,
    right: box.right + 3,
    bottom: box.bottom + 3,
  };
  const strength = strengthOf(size);
  context.lineJoin = "round";
  context.lineCap = size < kFineBelow ? "butt" : "round";
  context.lineWidth = 1;
  if (strength > 0) {
    context.globalAlpha = strength;
    if (layers.distances) drawDistances(context, picture, near);
    if (layers.centres) yield* drawCentres(context, picture, near);
    if (layers.dual) yield* drawDual(context, picture, near);
    if (layers.cells) yield* drawCells(context, picture, near, size, expected);
    if (layers.vertices) drawVertices(context, picture, near);
    context.globalAlpha = 1;
  }
  if (layers.levels) yield* drawLevels(context, picture, near);
  if (layers.hull) drawHull(context, picture, near);
}

function* drawCells(
  context: CanvasRenderingContext2D,
  picture: Picture,
  box: Box,
  size: number,
  expected: number,
) {
  const { sites, view, layers, theme, ends, isLive } = picture;
  const bounds = boundsOf(view, box);
  if (!bounds) return;
  const isFine = size < kFineBelow;
  context.lineWidth = isFine ? 1 : 1.25;
  context.strokeStyle = theme.cell;
  const strokes = new ScreenStrokes(context, view, box);
  const { diagram } = sites;
  const count = diagram.visibleSize;
  const isDense = count <= kMostWhole && kCheaper * expected > count;
  const drawWhole = (target: PathContext) => {
    (ends ?? diagram.voronoi(bounds)).render(target, drawOptions(view, isLive && isFine));
    const isOnMap = sites.info.map && layers.map; // which has a coast
    if (ends && !isOnMap) ends.renderBounds(target);
  };
  if (isLive) {
    drawWhole(strokes);
  } else if (ends || count <= kAlwaysWhole || isDense) {
    const edges = new Recording();
    drawWhole(edges);
    yield* edges.play(strokes);
  } else yield* drawEdges(diagram, bounds, strokes);
  strokes.finish();
}

/** A drawing that is played later, in slices. */
class Recording {
  #numbers: number[] = [];
  #lengths: number[] = []; // of the commands: 2 moves, 3 is a line, 6 a curve
  #startX = 0;
  #startY = 0;

  moveTo(x: number, y: number) {
    this.#lengths.push(2);
    this.#numbers.push(x, y);
    this.#startX = x;
    this.#startY = y;
  }

  lineTo(x: number, y: number) {
    this.#lengths.push(3);
    this.#numbers.push(x, y);
  }

  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number) {
    this.#lengths.push(6);
    this.#numbers.push(x1, y1, x2, y2, x, y);
  }

  closePath() {
    this.lineTo(this.#startX, this.#startY);
  }

  *play(target: EdgeTarget) {
    const numbers = this.#numbers;
    let at = 0;
    let played = 0;
    for (const length of this.#lengths) {
      const [x, y] = [numbers[at], numbers[at + 1]];
      if (length === 2) target.moveTo(x, y);
      else if (length === 3) target.lineTo(x, y);
      else {
        const end = at + 4;
        const [x2, y2] = [numbers[at + 2], numbers[at + 3]];
        target.bezierCurveTo(x, y, x2, y2, numbers[end], numbers[end + 1]);
      }
      at += length === 6 ? 6 : 2;
      if (++played % kPlayed === 0) yield;
    }
  }
}

/** In each cell the lines of equal distance to its site, like heights on a map. */
function drawDistances(
  context: CanvasRenderingContext2D,
  { sites, view, theme, ends }: Picture,
  box: Box,
) {
  const { diagram } = sites;
  if (diagram.visibleSize > kMostContoured) return;
  context.strokeStyle = theme.distance;
  for (const id of sites.ids) {
    if (sites.isHidden(id)) continue;
    const cell = extentOf(sites, view, id, box);
    if (!cell) continue;
    context.save();
    context.beginPath();
    addCell(context, sites, view, id, ends);
    context.clip();
    context.beginPath();
    const rim = sites.radius(id) * view.scale;
    // The first contours of a circle with a negative radius are missing.
    const first = rim < 0 ? rim - kContour * Math.floor(rim / kContour) : rim + kContour;
    const passed = Math.max(0, Math.floor((cell.nearest - first) / kContour));
    for (let r = first + passed * kContour; r < cell.farthest; r += kContour)
      addRim(context, view, cell.x, cell.y, r);
    context.stroke();
    context.restore();
  }
}

/** Where a cell's site is, and from where to where the cell reaches; null outside of the box. */
function extentOf(sites: Sites, view: View, id: number, box: Box) {
  const corners = cellCorners(sites, view, id);
  if (!corners) return null;
  const site = sites.site(id);
  const [x, y] = [view.toScreenX(site.x), view.toScreenY(site.y)];
  const xs = corners.map((corner) => view.toScreenX(corner[0]));
  const ys = corners.map((corner) => view.toScreenY(corner[1]));
  const isOutside =
    Math.max(...xs) < box.left ||
    Math.min(...xs) > box.right ||
    Math.max(...ys) < box.top ||
    Math.min(...ys) > box.bottom;
  if (isOutside) return null;
  const [toBoxX, toBoxY] = [
    Math.max(box.left - x, x - box.right, 0),
    Math.max(box.top - y, y - box.bottom, 0),
  ];
  return {
    x,
    y,
    nearest: Math.hypot(toBoxX, toBoxY),
    farthest: Math.max(...xs.map((cx, k) => Math.hypot(cx - x, ys[k] - y))),
  };
}

function* drawDual(context: CanvasRenderingContext2D, { sites, view, theme }: Picture, box: Box) {
  context.lineWidth = 1;
  context.strokeStyle = theme.dual;
  const strokes = new ScreenStrokes(context, view, box);
  const bounds = boundsOf(view, box);
  sites.diagram.render(strokes, bounds ? { ...drawOptions(view), bounds } : drawOptions(view));
  strokes.finish();
  yield;
}

/** The point Voronoi diagram of the same centres. */
function* drawCentres(
  context: CanvasRenderingContext2D,
  { sites, view, theme }: Picture,
  box: Box,
) {
  const bounds = boundsOf(view, box);
  if (!bounds || sites.size > kMostCompared) return;
  const centres = new Diagram(sites.triples(sites.ids).map((v, k) => (k % 3 === 2 ? 0 : v)));
  yield;
  context.lineWidth = 1;
  context.strokeStyle = theme.centres;
  context.setLineDash([4, 4]);
  const strokes = new ScreenStrokes(context, view, box);
  centres.voronoi(bounds).render(strokes, drawOptions(view));
  strokes.finish();
  context.setLineDash([]);
  centres.dispose();
}

function drawHull(context: CanvasRenderingContext2D, { sites, view, theme }: Picture, box: Box) {
  context.lineWidth = 1.5;
  context.strokeStyle = theme.hull;
  const strokes = new ScreenStrokes(context, view, box);
  sites.diagram.renderHull(strokes, drawOptions(view));
  strokes.finish();
}

/** Vertices, and the empty circles about them, which touch three sites. */
function drawVertices(
  context: CanvasRenderingContext2D,
  { sites, view, theme }: Picture,
  box: Box,
) {
  if (sites.diagram.visibleSize > kMostVertices) return;
  const { xy, clearance } = sites.diagram.vertices();
  const found: [x: number, y: number, r: number][] = [];
  clearance.forEach((distance, k) => {
    const x = view.toScreenX(xy[2 * k]);
    const y = view.toScreenY(xy[2 * k + 1]);
    const r = distance * view.scale;
    const reach = Math.max(r, 3);
    if (x + reach < box.left || x - reach > box.right) return;
    if (y + reach < box.top || y - reach > box.bottom) return;
    found.push([x, y, r]);
  });
  context.lineWidth = 1;
  context.strokeStyle = theme.empty;
  context.beginPath();
  for (const [x, y, r] of found) {
    if (r >= 2) addRim(context, view, x, y, r);
  }
  context.stroke();
  context.fillStyle = theme.vertex;
  context.beginPath();
  for (const [x, y] of found) {
    context.moveTo(x + 2, y);
    context.arc(x, y, 2, 0, 2 * Math.PI);
  }
  context.fill();
}
