// The overlay follows the pointer: the nearest site, its cell and its neighbours, and the other
// answers; the selected sites and the handle of one; a circle that is being drawn, with its cell to
// be.
import type { Circle } from "../model/circle.js";
import type { Sites } from "../model/sites.js";
import { addCell } from "./curves.js";
import { addRim, fillAndStroke } from "./discs.js";
import type { Picture } from "./picture.js";
import type { Theme } from "../../shared/theme.js";
import type { Box, View } from "./view.js";

/** Pointer in pixels, all else in units; `nearest`, `under`, `empty` if they are asked for. */
export type Hover = {
  x: number;
  y: number;
  id: number;
  distance: number;
  neighbors: Uint32Array;
  nearest: Uint32Array;
  under: Uint32Array;
  empty: { x: number; y: number; r: number } | null;
};
export type Draw = (context: CanvasRenderingContext2D, picture: Picture) => void;
/** `revived` draws circles that come to light. */
export type Overlay = {
  hover: Hover | null;
  selected: readonly number[];
  draft: Circle | null;
  box: Box | null;
  revived: Draw | null;
};

/**
 * Space between a selected circle's rim and its ring, in pixels; the handle sits on the ring's
 * east.
 */
const kRing = 5;
const kSmallestRing = 11;
const kMostRings = 3000;

/** Where the selected circle's handle is, in pixels. */
export function handleOf(view: View, sites: Sites, id: number) {
  const radius = ringRadius(view, sites.site(id).r);
  const { x, y } = sites.site(id);
  return { x: view.toScreenX(x) + radius, y: view.toScreenY(y), radius };
}

const ringRadius = (view: View, r: number) => Math.max(r * view.scale + kRing, kSmallestRing);

/**
 * The radius, in the diagram's units, that puts the handle at this distance (pixels) from the
 * centre.
 */
export const radiusForHandle = (view: View, distance: number) =>
  Math.max(0, distance - kRing) / view.scale;

export function drawOverlay(context: CanvasRenderingContext2D, picture: Picture, overlay: Overlay) {
  const { sites, view, theme } = picture;
  context.lineJoin = "round";
  context.lineCap = "round";
  const { hover, selected, draft, box } = overlay;
  if (hover && hover.id >= 0) drawHover(context, picture, hover);
  if (selected.length > 0) drawSelected(context, sites, view, theme, selected);
  if (draft) drawDraft(context, picture, draft);
  overlay.revived?.(context, picture);
  if (box) {
    context.fillStyle = theme.selectedFill;
    context.strokeStyle = theme.selected;
    context.lineWidth = 1;
    const { left, top, right, bottom } = box;
    context.fillRect(left, top, right - left, bottom - top);
    context.strokeRect(left + 0.5, top + 0.5, right - left, bottom - top);
  }
}

function drawHover(
  context: CanvasRenderingContext2D,
  { sites, view, theme, ends }: Picture,
  hover: Hover,
) {
  context.fillStyle = theme.neighborFill;
  context.beginPath();
  for (const id of hover.neighbors) addCell(context, sites, view, id, ends);
  context.fill();

  context.fillStyle = theme.accentFill;
  context.beginPath();
  addCell(context, sites, view, hover.id, ends);
  context.fill();
  context.strokeStyle = theme.accent;
  context.lineWidth = 2;
  context.stroke();

  context.strokeStyle = theme.neighbor;
  context.lineWidth = 1.5;
  context.beginPath();
  for (const id of hover.neighbors) addCircle(context, sites, view, id);
  context.stroke();

  if (hover.under.length > 0) {
    context.strokeStyle = theme.ink;
    context.lineWidth = 2;
    context.beginPath();
    for (const id of hover.under) addCircle(context, sites, view, id);
    context.stroke();
  }

  drawNearest(context, sites, view, theme, hover.id);
  drawDistance(context, sites, view, theme, hover);
  if (hover.empty) drawEmpty(context, view, theme, hover.empty);
  if (hover.nearest.length > 0) drawRanks(context, sites, view, theme, hover);
}

/** The nearest circle; of a negative radius the ring whose far side counts, dotted. */
function drawNearest(
  context: CanvasRenderingContext2D,
  sites: Sites,
  view: View,
  theme: Theme,
  id: number,
) {
  const { x, y, r } = sites.site(id);
  const [px, py] = [view.toScreenX(x), view.toScreenY(y)];
  context.strokeStyle = theme.accent;
  context.lineWidth = 2.5;
  if (r >= 0) {
    context.fillStyle = theme.accentSite;
    fillAndStroke(context, view, px, py, Math.max(r * view.scale, 2));
    return;
  }
  drawFarRing(context, sites, view, id);
}

/** Draws for a negative radius the ring whose far side distances go to. */
function drawFarRing(context: CanvasRenderingContext2D, sites: Sites, view: View, id: number) {
  const { x, y, r } = sites.site(id);
  context.lineWidth = 1.5;
  context.setLineDash([2, 5]);
  context.beginPath();
  addRim(context, view, view.toScreenX(x), view.toScreenY(y), -r * view.scale);
  context.stroke();
  context.setLineDash([]);
  context.lineWidth = 2;
}

/**
 * The empty circle about the pointer, which touches the nearest site, and the way to the point
 * where it does.
 */
function drawDistance(
  context: CanvasRenderingContext2D,
  sites: Sites,
  view: View,
  theme: Theme,
  hover: Hover,
) {
  const radius = hover.distance * view.scale;
  const site = sites.site(hover.id);
  if (!(radius > 3)) return;
  const dx = view.toScreenX(site.x) - hover.x;
  const dy = view.toScreenY(site.y) - hover.y;
  const length = Math.hypot(dx, dy);
  context.strokeStyle = theme.pointer;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(hover.x, hover.y);
  context.lineTo(hover.x + (dx / length) * radius, hover.y + (dy / length) * radius);
  context.stroke();
  context.setLineDash([1, 4]);
  context.beginPath();
  addRim(context, view, hover.x, hover.y, radius);
  context.stroke();
  context.setLineDash([]);
}

/** The largest empty circle about the cell's corner that is nearest to the pointer. */
function drawEmpty(
  context: CanvasRenderingContext2D,
  view: View,
  theme: Theme,
  { x, y, r }: Circle,
) {
  const [px, py] = [view.toScreenX(x), view.toScreenY(y)];
  context.fillStyle = theme.emptyFill;
  context.strokeStyle = theme.vertex;
  context.lineWidth = 1.5;
  fillAndStroke(context, view, px, py, Math.max(r * view.scale, 1));
  context.fillStyle = theme.vertex;
  context.beginPath();
  context.arc(px, py, 3, 0, 2 * Math.PI);
  context.fill();
}

/** The nearest ones, numbered. */
function drawRanks(
  context: CanvasRenderingContext2D,
  sites: Sites,
  view: View,
  theme: Theme,
  hover: Hover,
) {
  context.font = `600 11px ${theme.sans}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  hover.nearest.forEach((id, k) => {
    const { x, y } = sites.site(id);
    const [px, py] = [view.toScreenX(x), view.toScreenY(y)];
    context.beginPath();
    context.arc(px, py, 9, 0, 2 * Math.PI);
    context.fillStyle = theme.paper;
    context.fill();
    context.strokeStyle = k === 0 ? theme.accent : theme.ink;
    context.lineWidth = 1.5;
    context.stroke();
    context.fillStyle = theme.ink;
    context.fillText(String(k + 1), px, py + 0.5);
  });
}

function drawSelected(
  context: CanvasRenderingContext2D,
  sites: Sites,
  view: View,
  theme: Theme,
  selected: readonly number[],
) {
  context.strokeStyle = theme.selected;
  context.lineWidth = 2;
  context.beginPath();
  for (const id of selected.slice(0, kMostRings)) {
    const { x, y, r } = sites.site(id);
    const radius = ringRadius(view, r);
    addRim(context, view, view.toScreenX(x), view.toScreenY(y), radius);
  }
  context.stroke();
  if (selected.length > 1) return;
  drawCover(context, sites, view, selected[0]);
  if (sites.site(selected[0]).r < 0) drawFarRing(context, sites, view, selected[0]);
  const { x, y } = handleOf(view, sites, selected[0]);
  context.fillStyle = theme.paper;
  context.beginPath();
  context.arc(x, y, 5.5, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
}

/** Draws for a hidden circle the one that covers it. */
function drawCover(context: CanvasRenderingContext2D, sites: Sites, view: View, id: number) {
  if (!sites.isHidden(id)) return;
  context.setLineDash([6, 4]);
  context.beginPath();
  addCircle(context, sites, view, sites.diagram.coverOf(id));
  context.stroke();
  context.setLineDash([]);
}

/** A circle to be, and the cell that it would have. */
function drawDraft(
  context: CanvasRenderingContext2D,
  { sites, view, theme, ends }: Picture,
  draft: Circle,
) {
  context.strokeStyle = theme.selected;
  context.fillStyle = theme.selectedFill;
  context.lineWidth = 1.5;
  context.setLineDash([5, 4]);
  context.beginPath();
  sites.tryOut(draft, (id) => addCell(context, sites, view, id, ends));
  context.fill();
  context.stroke();
  context.setLineDash([]);
  const [x, y] = [view.toScreenX(draft.x), view.toScreenY(draft.y)];
  fillAndStroke(context, view, x, y, Math.max(draft.r * view.scale, 2));
}

function addCircle(context: CanvasRenderingContext2D, sites: Sites, view: View, id: number) {
  const site = sites.site(id);
  const r = Math.max(site.r * view.scale, 2);
  addRim(context, view, view.toScreenX(site.x), view.toScreenY(site.y), r);
}
