// The static picture: circles, cell boundaries, dual graph, hidden sites. Drawn whole, or inside
// one box only.
import { boundsOf, drawOptions, ScreenStrokes } from "./curves.js";

/**
 * @typedef {{ cells: boolean, circles: boolean, dual: boolean, hidden: boolean, map: boolean }}
 * Layers what is shown
 */

const kDot = 1.1; // circles smaller than this (pixels) are drawn as dots of this size
const kDashFrom = 5; // hidden circles at least this large (pixels) are dashed
// visible circles at least this large (pixels) show their name, if it fits into them
const kNameFrom = 15;
const kMostInPath = 2000; // circles in one path: very long paths are slow to stroke

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import("./scene.js").Scene} scene
 * @param {import("./view.js").View} view
 * @param {Layers} layers
 * @param {Record<string, string>} theme
 * @param {import("./view.js").Box} box
 */
export function drawBase(context, scene, view, layers, theme, box) {
  const near = {
    left: box.left - 3,
    top: box.top - 3,
    right: box.right + 3,
    bottom: box.bottom + 3,
  };
  const visible = [];
  const hidden = [];
  sortCircles(scene, view, near, visible, hidden);
  context.lineJoin = "round";
  context.lineCap = "round";
  if (layers.circles) drawCircles(context, visible, theme.siteFill, "fill");
  if (layers.dual) {
    context.strokeStyle = theme.dual;
    context.lineWidth = 1;
    const strokes = new ScreenStrokes(context, view, near);
    scene.diagram.render(strokes, drawOptions(view));
    strokes.finish();
  }
  const bounds = boundsOf(view, near);
  if (layers.cells && bounds) {
    context.strokeStyle = theme.cell;
    context.lineWidth = 1;
    const strokes = new ScreenStrokes(context, view, near);
    scene.diagram.voronoi(bounds).render(strokes, drawOptions(view));
    strokes.finish();
  }
  if (layers.circles) {
    context.lineWidth = 1;
    drawCircles(context, visible, theme.site, "stroke");
  }
  if (layers.hidden) drawHidden(context, hidden, theme);
  if (layers.circles) drawNames(context, scene, view, near, theme);
}

/** Puts x, y, r in pixels of every circle that meets the box into one of two lists. */
function sortCircles(scene, view, box, visible, hidden) {
  const flags = scene.visible();
  const { xyr } = scene;
  for (const id of scene.ids) {
    const x = view.toScreenX(xyr[3 * id]);
    const y = view.toScreenY(xyr[3 * id + 1]);
    const r = Math.max(xyr[3 * id + 2] * view.scale, kDot);
    if (x + r < box.left || x - r > box.right || y + r < box.top || y - r > box.bottom) continue;
    (flags[id] ? visible : hidden).push(x, y, r);
  }
}

function drawCircles(context, xyr, style, how, dots = true) {
  context[how === "fill" ? "fillStyle" : "strokeStyle"] = style;
  context.beginPath();
  for (let k = 0; k < xyr.length; k += 3) {
    const x = xyr[k];
    const y = xyr[k + 1];
    const r = xyr[k + 2];
    if (k % (3 * kMostInPath) === 0 && k > 0 && how === "stroke") {
      context.stroke();
      context.beginPath();
    }
    if (r <= kDot && !dots) continue;
    context.moveTo(x + r, y);
    context.arc(x, y, r, 0, 2 * Math.PI);
  }
  context[how]();
}

function drawHidden(context, xyr, theme) {
  drawCircles(context, xyr, theme.hiddenFill, "fill");
  context.lineWidth = 1;
  const small = [];
  const large = [];
  for (let k = 0; k < xyr.length; k += 3)
    (xyr[k + 2] < kDashFrom ? small : large).push(xyr[k], xyr[k + 1], xyr[k + 2]);
  drawCircles(context, small, theme.hidden, "stroke");
  context.setLineDash([3, 3]);
  context.lineCap = "butt";
  drawCircles(context, large, theme.hidden, "stroke");
  context.setLineDash([]);
}

const widths = new Map(); // of names, in pixels of the font below

/** Names of sites that have one, inside their circles. */
function drawNames(context, scene, view, box, theme) {
  if (scene.labels.size === 0) return;
  const flags = scene.visible();
  const { xyr } = scene;
  context.font = `500 11px ${theme.sans}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = theme.name;
  for (const [id, { name }] of scene.labels) {
    const r = xyr[3 * id + 2] * view.scale;
    if (r < kNameFrom || !flags[id]) continue;
    const x = view.toScreenX(xyr[3 * id]);
    const y = view.toScreenY(xyr[3 * id + 1]);
    if (x + r < box.left || x - r > box.right || y + r < box.top || y - r > box.bottom) continue;
    let width = widths.get(name);
    if (width === undefined) {
      width = context.measureText(name).width;
      widths.set(name, width);
    }
    if (width < 2 * r - 2 && !isCrowded(scene, view, flags, id, x, y, width / 2 + 4))
      context.fillText(name, x, y);
  }
}

/** Whether another visible circle has its centre where the name would be. */
function isCrowded(scene, view, flags, id, x, y, halfWidth) {
  const { xyr } = scene;
  for (const other of scene.ids) {
    if (other === id || !flags[other]) continue;
    if (
      Math.abs(view.toScreenX(xyr[3 * other]) - x) < halfWidth &&
      Math.abs(view.toScreenY(xyr[3 * other + 1]) - y) < 9
    )
      return true;
  }
  return false;
}
