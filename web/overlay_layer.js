// What follows the pointer: the nearest site, its cell and its neighbours; the distance; the
// selected site and its handle.
import { addCell } from "./curves.js";

/**
 * @typedef {{ x: number, y: number, id: number, distance: number, neighbors: Uint32Array }} Hover
 * pointer in pixels, distance in units
 */

/**
 * Space between a selected circle's rim and its ring, in pixels; the handle sits on the ring's
 * east.
 */
const kRing = 5;
const kSmallestRing = 11;

/** Where the selected circle's handle is, in pixels. */
export function handleOf(view, site) {
  const radius = ringRadius(view, site);
  return { x: view.toScreenX(site.x) + radius, y: view.toScreenY(site.y), radius };
}

function ringRadius(view, site) {
  return Math.max(site.r * view.scale + kRing, kSmallestRing);
}

/**
 * The radius, in the diagram's units, that puts the handle at this distance (pixels) from the
 * centre.
 */
export function radiusForHandle(view, distance) {
  return Math.max(0, distance - kRing) / view.scale;
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import("./scene.js").Scene} scene
 * @param {import("./view.js").View} view
 * @param {Record<string, string>} theme
 * @param {Hover | null} hover
 * @param {number} selected id or -1
 * @param {{ x: number, y: number, r: number } | null} draft a circle that is being drawn
 */
export function drawOverlay(context, scene, view, theme, hover, selected, draft) {
  context.lineJoin = "round";
  context.lineCap = "round";
  if (hover && hover.id >= 0) drawHover(context, scene, view, theme, hover);
  if (selected >= 0) drawSelected(context, scene, view, theme, selected);
  if (draft) {
    context.strokeStyle = theme.accent;
    context.fillStyle = theme.accentFill;
    context.lineWidth = 1.5;
    circle(context, view, draft);
    context.fill();
    context.stroke();
  }
}

function drawHover(context, scene, view, theme, hover) {
  context.fillStyle = theme.neighborFill;
  context.beginPath();
  for (const id of hover.neighbors) addCell(context, scene, view, id);
  context.fill();

  context.fillStyle = theme.accentFill;
  context.beginPath();
  addCell(context, scene, view, hover.id);
  context.fill();
  context.strokeStyle = theme.accent;
  context.lineWidth = 2;
  context.stroke();

  context.strokeStyle = theme.neighbor;
  context.lineWidth = 1.5;
  context.beginPath();
  for (const id of hover.neighbors) addCircle(context, view, scene.site(id));
  context.stroke();

  const site = scene.site(hover.id);
  context.fillStyle = theme.accentSite;
  context.strokeStyle = theme.accent;
  context.lineWidth = 2;
  circle(context, view, site);
  context.fill();
  context.stroke();
  drawDistance(context, view, theme, hover, site);
}

/**
 * The empty circle about the pointer, which touches the nearest site, and the way to the point
 * where it does.
 */
function drawDistance(context, view, theme, hover, site) {
  const radius = hover.distance * view.scale;
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
  context.arc(hover.x, hover.y, radius, 0, 2 * Math.PI);
  context.stroke();
  context.setLineDash([]);
}

function drawSelected(context, scene, view, theme, id) {
  const site = scene.site(id);
  const { x, y, radius } = handleOf(view, site);
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.25;
  context.setLineDash([2, 4]);
  context.beginPath();
  context.arc(x - radius, y, radius, 0, 2 * Math.PI);
  context.stroke();
  context.setLineDash([]);
  context.fillStyle = theme.paper;
  context.lineWidth = 1.75;
  context.beginPath();
  context.arc(x, y, 5, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
}

function circle(context, view, site) {
  context.beginPath();
  addCircle(context, view, site);
}

function addCircle(context, view, site) {
  const x = view.toScreenX(site.x);
  const y = view.toScreenY(site.y);
  const r = Math.max(site.r * view.scale, 2);
  context.moveTo(x + r, y);
  context.arc(x, y, r, 0, 2 * Math.PI);
}
