// The cells of a whole tree: groups of siblings, one after the other, each in the cell of its
// parent.
import { described } from "../core/arguments.js";
import { Diagram } from "../core/diagram.js";
import { ApolloniusError } from "../errors.js";
import { voronoi } from "../shapes/functions.js";
import { type Cell, cellsIn, onlyCell, type Window, windowOf } from "./cells.js";
import { circlesOf, fitted, type Limits, type Start, type Work } from "./fit.js";
import { randomOf, settled, spread } from "./places.js";
import { isInside, momentsOf } from "./rings.js";
import {
  childrenOf,
  type Input,
  nameOf,
  paddingOf,
  positionOf,
  type Settings,
  usualKey,
} from "./settings.js";

/** Share of the areas that all levels together may be off by. */
const kError = 5e-7;
/** So much of the way to its centroid a site moves from one layout to the next. */
const kWayOfFrame = 0.25;
/** The polygon of a window whose sides cross is made again, finer, when its area is off by this. */
const kAreaOff = 1e-9;
const kFiner = 1 / 16;
const kMostRefinings = 4;

interface Group {
  readonly children: readonly Input[];
  readonly targets: Float64Array;
  readonly random: () => number;
}

/** All nodes with a cell; `previous` is an earlier layout, or null. */
export function* layOut(
  root: Input,
  values: ReadonlyMap<Input, number>,
  settings: Settings,
  previous: Input | null,
): Work<Map<Input, Cell>> {
  const cells = new Map<Input, Cell>();
  if (!(values.get(root)! > 0)) return cells;
  const { cell, tolerance } = settings.shape;
  cells.set(root, { ...cell });
  const groups = new Map<Input, readonly Input[]>();
  for (const node of values.keys()) {
    const children = childrenOf(node).filter((child) => values.get(child)! > 0);
    if (children.length > 0) groups.set(node, children);
  }
  const error = kError / levelsOf(values, groups);
  const all = [...groups.values()].reduce((sum, { length }) => sum + length, 0);
  const before = new Map<Input, Input>();
  if (previous !== null) before.set(root, previous);
  let [which, finished] = [0, 0];
  for (const [node, children] of groups) {
    ++which;
    const own = cells.get(node);
    if (own === undefined) continue; // below a node without a value
    matchChildren(before, node, settings);
    const targets = Float64Array.from(children, (child) => values.get(child)!);
    const group = { children, targets, random: randomOf(settings.seed, which) };
    const share = children.length / all;
    const done = finished / all;
    const found = yield* fill(node, own, group, settings, before, {
      tolerance,
      error,
      done,
      share,
    });
    children.forEach((child, k) => cells.set(child, found[k]!));
    finished += children.length;
  }
  return cells;
}

/** The most levels on which siblings share a cell. */
function levelsOf(
  values: ReadonlyMap<Input, number>,
  groups: ReadonlyMap<Input, readonly Input[]>,
): number {
  const levels = new Map<Input, number>();
  let last = 0;
  for (const node of [...values.keys()].reverse()) {
    const children = groups.get(node) ?? [];
    const below = children.reduce((most, child) => Math.max(most, levels.get(child)!), 0);
    last = below + (children.length > 1 ? 1 : 0);
    levels.set(node, last);
  }
  return Math.max(1, last); // of the root
}

/**
 * Notes which nodes of the previous layout the children of a node are. Throws "bad-option" where
 * their keys do not tell.
 */
function matchChildren(before: Map<Input, Input>, node: Input, { key }: Settings): void {
  const old = before.get(node);
  if (old === undefined) return;
  if (old === node) {
    for (const child of childrenOf(node)) before.set(child, child);
    return;
  }
  const gone = byKey(old, key);
  const isNameless = (child: Input) =>
    !key && typeof child.data !== "string" && usualKey(child) === child.data;
  let added: Input | undefined; // a nameless one
  for (const [own, child] of byKey(node, key)) {
    const match = gone.get(own);
    if (match !== undefined) before.set(child, match);
    else if (isNameless(child)) added = child;
    gone.delete(own);
  }
  if (added !== undefined && [...gone.values()].some(isNameless))
    throw unmatched(node, "have no names, and other data");
}

/** Children by their keys; dates are compared by their time, as d3-array does. */
function byKey(node: Input, key: Settings["key"]): Map<unknown, Input> {
  const found = new Map<unknown, Input>();
  for (const [index, child] of childrenOf(node).entries()) {
    const own = (key ?? usualKey)(child, index);
    const value = own instanceof Date ? own.getTime() : own;
    if (found.has(value)) throw unmatched(node, `have twice the key ${described(own)}`);
    found.set(value, child);
  }
  return found;
}

function unmatched(node: Input, why: string): ApolloniusError {
  return new ApolloniusError(
    "bad-option",
    `children of ${nameOf(node)} ${why}: treemap().key(…) matches them with previous`,
  );
}

function* fill(
  node: Input,
  cell: Cell,
  group: Group,
  settings: Settings,
  before: ReadonlyMap<Input, Input>,
  limits: Limits,
): Work<Cell[]> {
  const padding = paddingOf(node, settings);
  const { children, targets } = group;
  if (children.length === 1) return [onlyCell(cell, windowOf(cell, padding, 1), padding)];
  for (let factor = 1, refinings = 0; ; factor *= kFiner, ++refinings) {
    const window = windowOf(cell, padding, factor);
    const start = startOf(node, cell, group, window, settings, before);
    using diagram = new Diagram(circlesOf(start.places, start.weights));
    using view = voronoi(diagram, window.rings);
    try {
      cell.fit = yield* fitted(view, window, targets, start, settings, limits);
    } catch (error) {
      throw ofNode(error, node);
    }
    const found = cellsIn(view, window, limits.tolerance);
    const area = found.reduce((sum, part) => sum + part.area, 0);
    const whole = momentsOf(window.rings).area;
    const isOff = padding === 0 && Math.abs(area - whole) > kAreaOff * whole;
    if (!isOff || refinings === kMostRefinings) return found;
  }
}

/** An error of a group of children, with the name of their parent. */
function ofNode(error: unknown, node: Input): unknown {
  if (!(error instanceof ApolloniusError) || error.code !== "no-convergence") return error;
  return new ApolloniusError(error.code, `children of ${nameOf(node)}: ${error.message}`);
}

/** Weights of discs with the areas that cells are to have. */
function radiiOf(targets: Float64Array, window: Window): Float64Array {
  const sum = targets.reduce((a, b) => a + b, 0);
  const area = momentsOf(window.rings).area;
  return targets.map((target) => Math.sqrt(((target / sum) * area) / Math.PI));
}

function startOf(
  node: Input,
  cell: Cell,
  { children, targets, random }: Group,
  window: Window,
  settings: Settings,
  before: ReadonlyMap<Input, Input>,
): Start {
  const { frame, rings } = window;
  const radii = radiiOf(targets, window);
  const old = before.get(node);
  const places = new Float64Array(2 * children.length).fill(NaN);
  const put = (k: number, x: number, y: number) =>
    places.set([(x - frame.x) / frame.scale, (y - frame.y) / frame.scale], 2 * k);
  const weights = radii.slice();
  let matches = 0;
  if (old?.centroid && old.area !== undefined) {
    // The window may have moved and grown, and its sites with it.
    const growth = (Math.sqrt(cell.area) * cell.frame.scale) / Math.sqrt(old.area);
    const x0 = cell.frame.x + cell.frame.scale * cell.x;
    const y0 = cell.frame.y + cell.frame.scale * cell.y;
    const [oldX, oldY] = old.centroid;
    children.forEach((child, k) => {
      const match = before.get(child);
      if (!match?.circle) return;
      const { x, y, r } = match.circle;
      const [toX, toY] = match.centroid ?? [x, y];
      const way = settings.sites === "move" ? kWayOfFrame : 0;
      const [newX, newY] = [x + way * (toX - x), y + way * (toY - y)];
      put(k, x0 + growth * (newX - oldX), y0 + growth * (newY - oldY));
      if (!isInside(rings, places[2 * k]!, places[2 * k + 1]!))
        put(k, x0 + growth * (x - oldX), y0 + growth * (y - oldY));
      weights[k] = (growth * r) / frame.scale;
      ++matches;
    });
  }
  const { position } = settings;
  if (matches === 0 && position === null)
    return {
      places: spread(rings, targets, random),
      weights,
      isOld: false,
      isGiven: false,
      random,
    };
  if (matches === 0) children.forEach((child, k) => put(k, ...positionOf(child, position!)));
  const isOld = matches > 0;
  return { places: settled(rings, places, random), weights, isOld, isGiven: !isOld, random };
}
