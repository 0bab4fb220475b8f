// From the graph's arrays to curves on the screen: Voronoi edges, dual edges, and whole cells.
import { asymptotes, newArc, setBisector, setDualEdge } from "./bisector.js";
import { drawConic } from "./conic.js";

/** @typedef {import("./bisector.js").Arc} Arc */
/** @typedef {import("./scene.js").Scene} Scene */
/** @typedef {import("./view.js").View} View */

const vertexOf = (graph, v) => (v < 0 ? null : { x: graph.coordinates[2 * v], y: graph.coordinates[2 * v + 1] });
const circleOf = (graph, v) =>
  v < 0 ? null : { x: graph.coordinates[2 * v], y: graph.coordinates[2 * v + 1], r: graph.clearance[v] };

/**
 * The Voronoi edge of one row, cut at about `reach` window radii from the middle of the window.
 * @param {Scene} scene
 * @param {ReturnType<View["disc"]>} disc
 * @param {Arc} arc receives it
 * @returns {boolean} whether anything is left
 */
export function setVoronoiArc(scene, row, disc, arc, reach = 1.1, cutBounded = true) {
  const graph = scene.graph();
  const { xyr } = scene;
  const a = 3 * graph.edgeSites[2 * row];
  const b = 3 * graph.edgeSites[2 * row + 1];
  const first = vertexOf(graph, graph.edgeVertices[2 * row]);
  const second = vertexOf(graph, graph.edgeVertices[2 * row + 1]);
  const distanceA = Math.hypot(xyr[a] - disc.x, xyr[a + 1] - disc.y);
  const distanceB = Math.hypot(xyr[b] - disc.x, xyr[b + 1] - disc.y);
  const far = Math.max(distanceA, distanceB) + reach * disc.radius;
  return setBisector(arc, xyr[a], xyr[a + 1], xyr[a + 2], xyr[b], xyr[b + 1], xyr[b + 2], first, second, far, cutBounded);
}

/** The dual edge of one row. @param {Scene} scene @param {Arc} arc receives it */
export function setDualArc(scene, row, arc) {
  const graph = scene.graph();
  const { xyr } = scene;
  const a = 3 * graph.edgeSites[2 * row];
  const b = 3 * graph.edgeSites[2 * row + 1];
  const first = circleOf(graph, graph.edgeVertices[2 * row]);
  const second = circleOf(graph, graph.edgeVertices[2 * row + 1]);
  setDualEdge(arc, xyr[a], xyr[a + 1], xyr[a + 2], xyr[b], xyr[b + 1], xyr[b + 2], first, second);
}

/** Adds an arc to a path if its control triangle meets the box; tells whether it does. @param {View} view @param {Arc} arc */
export function addArc(path, view, arc, box) {
  const x0 = view.toScreenX(arc.x0);
  const y0 = view.toScreenY(arc.y0);
  const x1 = view.toScreenX(arc.x1);
  const y1 = view.toScreenY(arc.y1);
  const x2 = view.toScreenX(arc.x2);
  const y2 = view.toScreenY(arc.y2);
  if (
    (x0 < box.left && x1 < box.left && x2 < box.left) ||
    (x0 > box.right && x1 > box.right && x2 > box.right) ||
    (y0 < box.top && y1 < box.top && y2 < box.top) ||
    (y0 > box.bottom && y1 > box.bottom && y2 > box.bottom)
  ) {
    return false;
  }
  path.moveTo(x0, y0);
  drawConic(path, x0, y0, x1, y1, arc.w, x2, y2);
  return true;
}

/** Adds the edges of one site's cell. */
export function addCellEdges(path, scene, view, id, box) {
  const arc = newArc();
  const disc = view.disc();
  for (const row of scene.edgesOf(id)) {
    if (setVoronoiArc(scene, row, disc, arc)) addArc(path, view, arc, box);
  }
}

/** Adds the straight or curved dual edges of one site. */
export function addDualEdges(path, scene, view, id, box) {
  const arc = newArc();
  for (const row of scene.edgesOf(id)) {
    setDualArc(scene, row, arc);
    addArc(path, view, arc, box);
  }
}

/**
 * The edges around a cell, counter-clockwise, as chains: a bounded cell is one closed chain; each chain of an unbounded one
 * starts and ends at infinity, and the chains are sorted by the direction in which they start.
 * @returns {{ rows: { row: number, from: number, to: number, turned: boolean }[], closed: boolean }[]}
 */
export function cellChains(scene, id) {
  const { edgeSites, edgeVertices } = scene.graph();
  const byStart = new Map();
  const starts = [];
  for (const row of scene.edgesOf(id)) {
    const turned = edgeSites[2 * row] !== id; // the edge's own direction has the other cell on the left
    const from = edgeVertices[2 * row + (turned ? 1 : 0)];
    const to = edgeVertices[2 * row + (turned ? 0 : 1)];
    const edge = { row, from, to, turned };
    if (from < 0) starts.push(edge);
    else byStart.set(from, edge);
  }
  const follow = (edge) => {
    const rows = [];
    for (let next = edge; next; next = byStart.get(next.to)) {
      rows.push(next);
      byStart.delete(next.from);
    }
    return rows;
  };
  if (starts.length === 0) {
    const [first] = byStart.values();
    return first ? [{ rows: follow(first), closed: true }] : [];
  }
  const chains = starts.map((edge) => ({ rows: follow(edge), closed: false }));
  const angle = (chain) => endDirection(scene, chain.rows[0], 0);
  return chains.sort((p, q) => angle(p) - angle(q));
}

/** The direction in which an unbounded edge, walked with the cell on the left, comes from (end 0) or goes to (end 1). */
function endDirection(scene, { row, turned }, end) {
  const { edgeSites } = scene.graph();
  const { xyr } = scene;
  const a = 3 * edgeSites[2 * row + (turned ? 1 : 0)];
  const b = 3 * edgeSites[2 * row + (turned ? 0 : 1)];
  const angle = asymptotes(xyr[a], xyr[a + 1], xyr[a + 2], xyr[b], xyr[b + 1], xyr[b + 2])[end];
  return angle - 2 * Math.PI * Math.floor(angle / (2 * Math.PI));
}

const kFar = 64; // unbounded ends are cut here, in window radii from the middle of the window …
const kRim = 16; // … and what lies further than this is pulled onto a circle of this size: nobody sees it
const kMostHalvings = 60;

/** Adds a site's whole cell as closed figures to be filled; correct inside the window. Nothing for a hidden site. */
export function addCell(path, scene, view, id) {
  const disc = view.disc();
  if (scene.ids.length > 0 && scene.isVisible(id) && scene.edgesOf(id).length === 0) {
    path.rect(0, 0, view.width, view.height);
    return;
  }
  const rim = new Rim(path, view, disc);
  const chains = cellChains(scene, id);
  chains.forEach((chain, k) => {
    for (const [n, edge] of chain.rows.entries()) {
      const arc = newArc();
      if (!setVoronoiArc(scene, edge.row, disc, arc, kFar, false)) continue;
      const q = rim.relative(edge.turned ? turn(arc) : arc);
      if (k === 0 && n === 0) rim.moveTo(q.x0, q.y0);
      else rim.lineTo(q.x0, q.y0);
      rim.conic(q.x0, q.y0, q.x1, q.y1, q.w, q.x2, q.y2, 0);
    }
    if (!chain.closed) {
      const next = chains[(k + 1) % chains.length];
      const leave = endDirection(scene, chain.rows.at(-1), 1);
      let sweep = endDirection(scene, next.rows[0], 0) - leave;
      sweep -= 2 * Math.PI * Math.floor(sweep / (2 * Math.PI));
      if (sweep > 2 * Math.PI - 1e-9) sweep = 0; // parallel edges, up to rounding
      rim.sweepTo(leave, sweep);
    }
  });
  path.closePath();
}

const turn = ({ x0, y0, x1, y1, w, x2, y2 }) => ({ x0: x2, y0: y2, x1, y1, w, x2: x0, y2: y0 });

/** Draws in window radii from the middle of the window (y upwards), and pulls what is far away onto the rim. */
class Rim {
  constructor(path, view, disc) {
    this.path = path;
    this.view = view;
    this.disc = disc;
  }

  relative({ x0, y0, x1, y1, w, x2, y2 }) {
    const { x, y, radius } = this.disc;
    const fx = (v) => (v - x) / radius;
    const fy = (v) => (v - y) / radius;
    return { x0: fx(x0), y0: fy(y0), x1: fx(x1), y1: fy(y1), w, x2: fx(x2), y2: fy(y2) };
  }

  screen(x, y) {
    const half = Math.hypot(this.view.width, this.view.height) / 2;
    return [this.view.width / 2 + x * half, this.view.height / 2 - y * half];
  }

  pulled(x, y) {
    const length = Math.hypot(x, y);
    return length <= kRim ? this.screen(x, y) : this.screen((x / length) * kRim, (y / length) * kRim);
  }

  moveTo(x, y) {
    this.path.moveTo(...this.pulled(x, y));
  }

  lineTo(x, y) {
    this.path.lineTo(...this.pulled(x, y));
  }

  /** Continues along the rim from the direction `from` by `sweep` radians, counter-clockwise. */
  sweepTo(from, sweep) {
    const steps = Math.ceil(sweep / 0.5);
    for (let k = 0; k <= steps; k++) {
      const angle = from + (steps ? (sweep * k) / steps : 0);
      this.lineTo(kRim * Math.cos(angle), kRim * Math.sin(angle));
    }
  }

  conic(x0, y0, x1, y1, w, x2, y2, depth) {
    const near = Math.max(Math.abs(x0), Math.abs(y0), Math.abs(x1), Math.abs(y1), Math.abs(x2), Math.abs(y2)) < kRim / 2;
    if (near) {
      drawConic(this.path, ...this.screen(x0, y0), ...this.screen(x1, y1), w, ...this.screen(x2, y2));
      return;
    }
    const outside = Math.min(Math.hypot(x0, y0), Math.hypot(x1, y1), Math.hypot(x2, y2)) > 2;
    if ((outside && angleBetween(x0, y0, x1, y1) + angleBetween(x1, y1, x2, y2) < 0.6) || depth >= kMostHalvings) {
      this.lineTo(x2, y2);
      return;
    }
    const u = 1 / (1 + w);
    const ax = (x0 + w * x1) * u;
    const ay = (y0 + w * y1) * u;
    const bx = (x2 + w * x1) * u;
    const by = (y2 + w * y1) * u;
    const mx = (ax + bx) / 2;
    const my = (ay + by) / 2;
    const half = Math.sqrt((1 + w) / 2);
    this.conic(x0, y0, ax, ay, half, mx, my, depth + 1);
    this.conic(mx, my, bx, by, half, x2, y2, depth + 1);
  }
}

const angleBetween = (ax, ay, bx, by) => Math.abs(Math.atan2(ax * by - ay * bx, ax * bx + ay * by));
