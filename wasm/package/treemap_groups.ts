// The children of a node in its cell: places, rounds of moves, areas. Each search for weights is
// yielded, so that who asks for the next one can wait in between, or not.
import { Diagram } from "./diagram.js";
import { ApolloniusError } from "./errors.js";
import { type Cell, cellsIn, onlyCell, rootCell, type Window, windowOf } from "./treemap_cells.js";
import { randomOf, settled, spread } from "./treemap_places.js";
import { isInside, momentsOf } from "./treemap_rings.js";
import {
  childrenOf,
  type Input,
  nameOf,
  paddingOf,
  positionOf,
  type Settings,
  usualKey,
} from "./treemap_settings.js";
import type { FitOptions, FittedAreas } from "./types.js";
import type { Voronoi } from "./voronoi.js";

/** A search for weights that is to be made; and how much of the whole layout is done. */
export interface Request {
  readonly view: Voronoi;
  readonly targets: Float64Array;
  readonly options: FitOptions;
  readonly done: number;
}
type Work<Result> = Generator<Request, Result, FittedAreas>;

/** Of the areas that all levels together may be off by. */
const kError = 5e-7;
/** While sites move. */
const kCoarse = 0.1;
/** Sites are at rest when none moves by more than this share of its cell's width. */
const kRest = 0.04;
/** The polygon of a window whose sides cross is made again, finer, when its area is off by this. */
const kAreaOff = 1e-9;
const kFiner = 1 / 16;
const kMostRefinings = 4;

interface Group {
  readonly children: readonly Input[];
  readonly targets: Float64Array;
  readonly random: () => number;
}

/** Where sites begin, and their weights, in the frame of their window. */
interface Start {
  readonly places: Float64Array;
  readonly weights: Float64Array;
  /** Are they those of an earlier layout? */
  readonly isOld: boolean;
}

/** All nodes with a cell. */
export function* layOut(
  root: Input,
  values: ReadonlyMap<Input, number>,
  settings: Settings,
): Work<Map<Input, Cell>> {
  const cells = new Map<Input, Cell>();
  if (!(values.get(root)! > 0)) return cells;
  const { cell, tolerance } = rootCell(settings.shape);
  cells.set(root, cell);
  const groups = new Map<Input, readonly Input[]>();
  for (const node of values.keys()) {
    const children = childrenOf(node).filter((child) => values.get(child)! > 0);
    if (children.length > 0) groups.set(node, children);
  }
  const error = kError / levelsOf(values, groups);
  const all = [...groups.values()].reduce((sum, { length }) => sum + length, 0);
  const before = new Map<Input, Input>();
  if (settings.previous !== null) before.set(root, settings.previous);
  let [which, finished] = [0, 0];
  for (const [node, children] of groups) {
    ++which;
    const own = cells.get(node);
    if (own === undefined) continue; // below a node without a value
    matchChildren(before, node, children, settings);
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

/** Notes which nodes of the previous layout the children of a node are. */
function matchChildren(
  before: Map<Input, Input>,
  node: Input,
  children: readonly Input[],
  { key }: Settings,
): void {
  const old = before.get(node);
  if (old === undefined) return;
  const keyOf = key ?? usualKey;
  const byKey = new Map(childrenOf(old).map((child, k) => [keyOf(child, k), child]));
  const all = childrenOf(node);
  for (const child of children) {
    const match = byKey.get(keyOf(child, all.indexOf(child)));
    if (match !== undefined) before.set(child, match);
  }
}

interface Limits {
  readonly tolerance: number;
  readonly error: number;
  readonly done: number;
  readonly share: number;
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
    using view = diagram.voronoi(window.rings);
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

function circlesOf(places: Float64Array, weights: Float64Array): Float64Array {
  const xyr = new Float64Array(3 * weights.length);
  weights.forEach((weight, k) => xyr.set([places[2 * k]!, places[2 * k + 1]!, weight], 3 * k));
  return xyr;
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
      if (!match?.site) return;
      const { x, y, r } = match.site;
      const [toX, toY] = settings.sites === "move" && match.centroid ? match.centroid : [x, y];
      put(k, x0 + growth * (toX - oldX), y0 + growth * (toY - oldY));
      if (!isInside(rings, places[2 * k]!, places[2 * k + 1]!))
        put(k, x0 + growth * (x - oldX), y0 + growth * (y - oldY));
      weights[k] = (growth * r) / frame.scale;
      ++matches;
    });
  }
  const { position } = settings;
  if (matches === 0 && position === null)
    return { places: spread(rings, targets, random), weights, isOld: false };
  if (matches === 0) children.forEach((child, k) => put(k, ...positionOf(child, position!)));
  return { places: settled(rings, places, random), weights, isOld: matches > 0 };
}

/** Moves sites, if they are to, and finds their weights. */
function* fitted(
  view: Voronoi,
  { rings }: Window,
  targets: Float64Array,
  { places, weights, isOld }: Start,
  { sites, rounds }: Settings,
  { error, done, share }: Limits,
): Work<NonNullable<Cell["fit"]>> {
  const { diagram } = view;
  const most = isOld || sites === "stay" ? 0 : rounds;
  let iterations = 0;
  let start = weights;
  for (let round = 0; round < most; ++round) {
    const options = { tolerance: kCoarse, start };
    const now = done + (share * round) / (most + 1);
    try {
      const found = yield { view, targets, options, done: now };
      iterations += found.iterations;
      start = found.weights;
    } catch (failure) {
      if (!(failure instanceof ApolloniusError && failure.code === "no-convergence")) throw failure;
      if (round > 0) diagram.updateMany(diagram.ids(), circlesOf(places, start));
      break; // from where it still went well
    }
    const moved = movedToCentroids(view, rings, places);
    if (moved.far < kRest) break;
    places = moved.places;
    diagram.updateMany(diagram.ids(), circlesOf(places, start));
  }
  const options = { tolerance: error, start };
  const found = yield { view, targets, options, done: done + (share * most) / (most + 1) };
  const { converged, error: reached } = found;
  return { iterations: iterations + found.iterations, error: reached, converged };
}

/** The centroids that are inside, and how far at most they are, in widths of cells. */
function movedToCentroids(
  view: Voronoi,
  rings: Window["rings"],
  places: Float64Array,
): { places: Float64Array; far: number } {
  const areas = view.cellAreas();
  const centroids = view.cellCentroids();
  const moved = places.slice();
  let far = 0;
  areas.forEach((area, k) => {
    const [x, y] = [centroids[2 * k]!, centroids[2 * k + 1]!];
    if (!isInside(rings, x, y)) return;
    const [dx, dy] = [x - places[2 * k]!, y - places[2 * k + 1]!];
    far = Math.max(far, Math.sqrt((dx * dx + dy * dy) / area));
    moved.set([x, y], 2 * k);
  });
  return { places: moved, far };
}
