// The static picture: circles, cell boundaries, dual graph, hidden sites. Drawn whole, or inside one box only.
import { newArc } from "./bisector.js";
import { addArc, setDualArc, setVoronoiArc } from "./curves.js";

/** @typedef {{ cells: boolean, circles: boolean, dual: boolean, hidden: boolean, map: boolean }} Layers what is shown */

const kDot = 1.1; // circles smaller than this (pixels) are drawn as dots of this size
const kDashFrom = 5; // hidden circles at least this large (pixels) are dashed
const kMostInPath = 2000; // pieces in one path: very long paths are slow to stroke

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import("./scene.js").Scene} scene
 * @param {import("./view.js").View} view
 * @param {Layers} layers
 * @param {Record<string, string>} theme
 * @param {import("./view.js").Box} box
 */
export function drawBase(context, scene, view, layers, theme, box) {
  const near = { left: box.left - 3, top: box.top - 3, right: box.right + 3, bottom: box.bottom + 3 };
  const visible = [];
  const hidden = [];
  sortCircles(scene, view, near, visible, hidden);
  context.lineJoin = "round";
  context.lineCap = "round";
  if (layers.circles) drawCircles(context, visible, theme.siteFill, "fill");
  if (layers.dual) {
    context.strokeStyle = theme.dual;
    context.lineWidth = 1;
    strokeRows(context, scene, view, near, (row, arc) => (setDualArc(scene, row, arc), true));
  }
  if (layers.cells) {
    const disc = view.disc();
    context.strokeStyle = theme.cell;
    context.lineWidth = 1;
    strokeRows(context, scene, view, near, (row, arc) => setVoronoiArc(scene, row, disc, arc));
  }
  if (layers.circles) {
    context.lineWidth = 1;
    drawCircles(context, visible, theme.site, "stroke");
  }
  if (layers.hidden) drawHidden(context, hidden, theme);
}

/** Puts x, y, r in pixels of every circle that meets the box into one of two lists. */
function sortCircles(scene, view, box, visible, hidden) {
  const flags = scene.graph().visible;
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
  for (let k = 0; k < xyr.length; k += 3) (xyr[k + 2] < kDashFrom ? small : large).push(xyr[k], xyr[k + 1], xyr[k + 2]);
  drawCircles(context, small, theme.hidden, "stroke");
  context.setLineDash([3, 3]);
  context.lineCap = "butt";
  drawCircles(context, large, theme.hidden, "stroke");
  context.setLineDash([]);
}

/** Strokes one curve for each edge, in paths of bounded length. */
function strokeRows(context, scene, view, box, setArc) {
  const { edgeCount } = scene.graph();
  const arc = newArc();
  for (let from = 0; from < edgeCount; from += kMostInPath) {
    context.beginPath();
    const to = Math.min(edgeCount, from + kMostInPath);
    for (let row = from; row < to; row++) {
      if (setArc(row, arc)) addArc(context, view, arc, box);
    }
    context.stroke();
  }
}
