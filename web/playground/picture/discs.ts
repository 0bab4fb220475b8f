// Circles of any size, in pixels. Browsers count pixels in floats, which far away lie pixels
// apart, and stop for seconds where they stroke or dash millions of them. So of a large circle only
// what is in the window goes into the path.
import { windowOf } from "./curves.js";
import type { Box, View } from "./view.js";

const kLarge = 4096; // pixels: smaller circles are drawn whole
const kMargin = 16; // pixels around the window, where lines may end unseen
const kPiece = Math.PI / 8; // of an arc: one cubic curve, off by less than 1e-7 of its radius
const kTurn = 2 * Math.PI;

/** Adds a circle, to be stroked. */
export function addRim(path: CanvasPath, view: View, x: number, y: number, r: number) {
  if (r <= kLarge) return addWhole(path, x, y, r);
  for (const { from, to } of arcsIn(frameOf(view), x, y, r)) {
    path.moveTo(x + r * Math.cos(from), y + r * Math.sin(from));
    addArc(path, x, y, r, from, to);
  }
}

/** Adds a disc, to be filled. */
export function addDisc(path: CanvasPath, view: View, x: number, y: number, r: number) {
  if (r <= kLarge) return addWhole(path, x, y, r);
  const box = frameOf(view);
  const arcs = arcsIn(box, x, y, r);
  if (arcs.length === 0) {
    const isCovered =
      Math.hypot((box.left + box.right) / 2 - x, (box.top + box.bottom) / 2 - y) < r;
    if (isCovered) path.rect(box.left, box.top, box.right - box.left, box.bottom - box.top);
    return;
  }
  // Disc and window are convex: around both, arcs and the frame's border take turns.
  const place = (angle: number) => placeOn(box, x + r * Math.cos(angle), y + r * Math.sin(angle));
  arcs.forEach(({ from, to }, k) => {
    const start: [number, number] = [x + r * Math.cos(from), y + r * Math.sin(from)];
    if (k === 0) path.moveTo(...start);
    else path.lineTo(...start);
    addArc(path, x, y, r, from, to);
    const end = place(to);
    let next = place(arcs[(k + 1) % arcs.length].from);
    if (next < end) next += 4;
    for (let corner = Math.floor(end) + 1; corner <= next; ++corner)
      path.lineTo(...cornerOf(box, corner));
  });
  path.closePath();
}

function addWhole(path: CanvasPath, x: number, y: number, r: number) {
  path.moveTo(x + r, y);
  path.arc(x, y, r, 0, kTurn);
}

function frameOf(view: View): Box {
  const { left, top, right, bottom } = windowOf(view);
  return {
    left: left - kMargin,
    top: top - kMargin,
    right: right + kMargin,
    bottom: bottom + kMargin,
  };
}

/** The parts of a circle within a box: from angle to angle, from < to, in order. */
function arcsIn(box: Box, x: number, y: number, r: number) {
  const cuts = [];
  for (const side of [box.left, box.right]) {
    const angle = Math.acos((side - x) / r); // NaN if the circle does not reach it
    cuts.push(angle, kTurn - angle);
  }
  for (const side of [box.top, box.bottom]) {
    const angle = Math.asin((side - y) / r);
    cuts.push((angle + kTurn) % kTurn, Math.PI - angle);
  }
  const angles = cuts.filter((angle) => !Number.isNaN(angle)).sort((a, b) => a - b);
  return angles.flatMap((from, k) => {
    const to = k + 1 < angles.length ? angles[k + 1] : angles[0] + kTurn;
    const middle = (from + to) / 2;
    const [px, py] = [x + r * Math.cos(middle), y + r * Math.sin(middle)];
    const isInside = px > box.left && px < box.right && py > box.top && py < box.bottom;
    return isInside && from < to ? [{ from, to }] : [];
  });
}

/** Continues a path along an arc, by cubic curves. */
function addArc(path: CanvasPath, x: number, y: number, r: number, from: number, to: number) {
  const count = Math.ceil((to - from) / kPiece);
  const step = (to - from) / count;
  const reach = (4 / 3) * Math.tan(step / 4) * r;
  for (let k = 0; k < count; ++k) {
    const [a, b] = [from + k * step, from + (k + 1) * step];
    const [ax, ay] = [x + r * Math.cos(a), y + r * Math.sin(a)];
    const [bx, by] = [x + r * Math.cos(b), y + r * Math.sin(b)];
    path.bezierCurveTo(
      ax - reach * Math.sin(a),
      ay + reach * Math.cos(a),
      bx + reach * Math.sin(b),
      by - reach * Math.cos(b),
      bx,
      by,
    );
  }
}

/** Where on a box's border a point is: from 0 to 4, a side for each unit, as angles turn. */
function placeOn(box: Box, x: number, y: number) {
  const [width, height] = [box.right - box.left, box.bottom - box.top];
  const sides = [
    [Math.abs(y - box.top), (x - box.left) / width],
    [Math.abs(x - box.right), (y - box.top) / height],
    [Math.abs(y - box.bottom), (box.right - x) / width],
    [Math.abs(x - box.left), (box.bottom - y) / height],
  ];
  const nearest = sides.reduce((best, side, k) => (side[0] < sides[best][0] ? k : best), 0);
  return nearest + Math.max(0, Math.min(sides[nearest][1], 1));
}

/** The corner at a whole place. */
function cornerOf(box: Box, place: number): [number, number] {
  const k = place % 4;
  return [k === 1 || k === 2 ? box.right : box.left, k >= 2 ? box.bottom : box.top];
}

/** A disc with its rim, in the context's styles; where and how large in pixels. */
export function fillAndStroke(
  context: CanvasRenderingContext2D,
  view: View,
  x: number,
  y: number,
  r: number,
) {
  context.beginPath();
  addDisc(context, view, x, y, r);
  context.fill();
  context.beginPath();
  addRim(context, view, x, y, r);
  context.stroke();
}
