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
import type { TreemapFit } from "./treemap_types.js";
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
const kMostCoarse = 60;
/** What rounding has left is no reason to look for other places. */
const kGoodEnough = 1e-3;
/** Of the values, for sites that are hard to find weights for. */
const kPowers = [0.25, 0.5, 0.75, 1, 1, 1, 1];
/** Sites are at rest when none moves by more than this share of its cell's width. */
const kRest = 0.04;
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

/** Where sites begin, and their weights, in the frame of their window. */
interface Start {
  readonly places: Float64Array;
  readonly weights: Float64Array;
  /** Are they those of an earlier layout? */
  readonly isOld: boolean;
  /** Are they given by the caller? */
  readonly isGiven: boolean;
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
    return { places: spread(rings, targets, random), weights, isOld: false, isGiven: false };
  if (matches === 0) children.forEach((child, k) => put(k, ...positionOf(child, position!)));
  const isOld = matches > 0;
  return { places: settled(rings, places, random), weights, isOld, isGiven: !isOld };
}

/** Moves sites, if they are to, and finds their weights. */
function* fitted(
  view: Voronoi,
  { rings }: Window,
  targets: Float64Array,
  { places, weights, isOld, isGiven }: Start,
  { sites, rounds }: Settings,
  { error, done, share }: Limits,
): Work<TreemapFit> {
  const search: Search = { view, rings, targets, places, weights, iterations: 0, done, share };
  if (sites === "move" && !isOld) yield* moved(search, new Array(rounds).fill(1));
  const mayMove = sites === "move" || !isGiven;
  let first: TreemapFit | null = null;
  try {
    first = yield* weighted(search, error);
    if (first.error < kGoodEnough || !mayMove) return first;
  } catch (failure) {
    if (!mayMove || !isNoConvergence(failure)) throw failure;
  }
  // From values that are less unequal to the true ones, so that each site has room of its own.
  const before = { ...search };
  search.weights = new Float64Array(weights.length);
  renew(search);
  yield* moved(search, kPowers);
  try {
    const second = yield* weighted(search, error);
    if (first === null || second.error < first.error) return second;
  } catch (failure) {
    if (first === null || !isNoConvergence(failure)) throw failure;
  }
  renew(before);
  return first;
}

interface Search {
  readonly view: Voronoi;
  readonly rings: Window["rings"];
  readonly targets: Float64Array;
  places: Float64Array;
  weights: Float64Array;
  iterations: number;
  done: number;
  share: number;
}

const isNoConvergence = (failure: unknown): boolean =>
  failure instanceof ApolloniusError && failure.code === "no-convergence";

/** The diagram with the places and weights of a search. */
function renew({ view: { diagram }, places, weights }: Search): void {
  diagram.updateMany(diagram.ids(), circlesOf(places, weights));
}

/** Weights for where sites are. */
function* weighted(search: Search, tolerance: number): Work<TreemapFit> {
  const { view, targets, weights, done } = search;
  const found = yield { view, targets, options: { tolerance, start: weights }, done };
  search.iterations += found.iterations;
  search.weights = found.weights;
  return { iterations: search.iterations, error: found.error, converged: found.converged };
}

/**
 * Moves sites to the centroids of cells whose areas are about in proportion to powers of the
 * values, one round for each power; fewer if they are at rest, or if weights are not found.
 */
function* moved(search: Search, powers: readonly number[]): Work<void> {
  const part = search.share / 2 / (powers.length + 1);
  for (const power of powers) {
    const targets = search.targets.map((target) => powerOf(target, power));
    const options = { tolerance: kCoarse, maxIterations: kMostCoarse, start: search.weights };
    try {
      const found = yield { view: search.view, targets, options, done: search.done };
      search.iterations += found.iterations;
      search.weights = found.weights;
    } catch (failure) {
      if (!isNoConvergence(failure)) throw failure;
      return renew(search); // where it still went well
    }
    search.done += part;
    search.share -= part;
    const { places, far } = movedToCentroids(search);
    if (power === 1 && far < kRest) return;
    search.places = places;
    renew(search);
  }
}

/** A quarter, half, three quarters, or one: by roots, which are the same on every machine. */
function powerOf(value: number, power: number): number {
  const root = Math.sqrt(value);
  if (power === 1) return value;
  return power === 0.5 ? root : power === 0.25 ? Math.sqrt(root) : root * Math.sqrt(root);
}

/** The centroids that are inside, and how far at most they are, in widths of cells. */
function movedToCentroids({ view, rings, places, targets }: Search): {
  places: Float64Array;
  far: number;
} {
  const perTarget = momentsOf(rings).area / targets.reduce((sum, target) => sum + target, 0);
  const centroids = view.cellCentroids();
  const result = places.slice();
  let far = 0;
  targets.forEach((target, k) => {
    const x = centroids[2 * k]!;
    const y = centroids[2 * k + 1]!;
    if (!isInside(rings, x, y)) return;
    const dx = x - places[2 * k]!;
    const dy = y - places[2 * k + 1]!;
    far = Math.max(far, Math.sqrt((dx * dx + dy * dy) / (perTarget * target)));
    result[2 * k] = x;
    result[2 * k + 1] = y;
  });
  return { places: result, far };
}
