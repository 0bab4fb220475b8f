// Weights for the sites of a group of siblings, and where they move meanwhile. Each search is
// yielded, so that who asks for the next one can wait in between, or not.
import { ApolloniusError } from "../errors.js";
import type { FitOptions, FittedAreas } from "../shapes/types.js";
import type { Voronoi } from "../shapes/voronoi.js";
import type { Window } from "./cells.js";
import { spread, Taken } from "./places.js";
import { isInside, momentsOf } from "./rings.js";
import type { Settings } from "./settings.js";
import type { TreemapFit } from "./types.js";

/** A search for weights that is to be made; and how much of the whole layout is done. */
export interface Request {
  readonly view: Voronoi;
  readonly targets: Float64Array;
  readonly options: FitOptions;
  readonly done: number;
}
export type Work<Result> = Generator<Request, Result, FittedAreas>;

/** While sites move. */
const kCoarse = 0.1;
const kMostCoarse = 60;
/** Steps of a search, and of one from other places if that has failed. */
const kMost = 300;
const kMostAgain = 100;
/** With values that differ by more than this factor rounding ends a search early. */
const kUnequal = 1e6;
/** A smaller error is no reason to look for other places; and how often they are looked for. */
const kEasy = { enough: 1e-6, attempts: 5 };
const kHard = { enough: 1e-3, attempts: 2 };
/** Powers of the values, for sites that are hard to find weights for. */
const kPowers = [0.25, 0.5, 0.75, 1, 1, 1, 1];
/** Sites are at rest when none moves by more than this share of its cell's width. */
const kRest = 0.04;
/** Where sites begin, and their weights, in the frame of their window. */
export interface Start {
  readonly places: Float64Array;
  readonly weights: Float64Array;
  /** Are they those of an earlier layout? */
  readonly isOld: boolean;
  /** Are they given by the caller? */
  readonly isGiven: boolean;
  readonly random: () => number;
}

/** Tolerances, of polygons and of areas; how much of the whole is done, and what this is of it. */
export interface Limits {
  readonly tolerance: number;
  readonly error: number;
  readonly done: number;
  readonly share: number;
}

/** x, y, r of each site. */
export function circlesOf(places: Float64Array, weights: Float64Array): Float64Array {
  const xyr = new Float64Array(3 * weights.length);
  for (let k = 0; k < weights.length; ++k) {
    xyr[3 * k] = places[2 * k]!;
    xyr[3 * k + 1] = places[2 * k + 1]!;
    xyr[3 * k + 2] = weights[k]!;
  }
  return xyr;
}

/** Moves sites, if they are to, and finds their weights. */
export function* fitted(
  view: Voronoi,
  { rings }: Window,
  targets: Float64Array,
  { places, weights, isOld, isGiven, random }: Start,
  { sites, rounds }: Settings,
  { error, done, share }: Limits,
): Work<TreemapFit> {
  const search: Search = { view, rings, targets, places, weights, iterations: 0, done, share };
  if (sites === "move" && !isOld) yield* moved(search, new Array(rounds).fill(1));
  const mayMove = sites === "move" || !isGiven;
  const largest = targets.reduce((a, b) => Math.max(a, b));
  const smallest = targets.reduce((a, b) => Math.min(a, b));
  const { enough, attempts } = largest > kUnequal * smallest ? kHard : kEasy;
  let best: { fit: TreemapFit; search: Search } | null = null;
  let failure: unknown = null;
  for (let attempt = 0; attempt < attempts; ++attempt) {
    if (attempt > 0 && (isGiven || attempt > 1)) search.places = spread(rings, targets, random);
    if (attempt === 1) {
      // From values that are less unequal to the true ones: each site gets room of its own.
      search.weights = new Float64Array(weights.length);
      renew(search);
      yield* moved(search, kPowers);
    } else if (attempt > 1) {
      // From far away: searches that begin near their end can be stuck between islands.
      search.weights = weights.map((weight) => weight * random());
      renew(search);
    }
    try {
      const fit = yield* weighted(search, error, attempt > 1 ? kMostAgain : kMost);
      if (fit.error < enough || !mayMove) return fit;
      if (best === null || fit.error < best.fit.error) best = { fit, search: { ...search } };
    } catch (thrown) {
      if (!mayMove || !isNoConvergence(thrown)) throw thrown;
      failure ??= thrown;
    }
  }
  if (best === null) throw failure;
  renew(best.search);
  return best.fit;
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
function* weighted(search: Search, tolerance: number, maxIterations: number): Work<TreemapFit> {
  const { view, targets, weights, done } = search;
  const options = { tolerance, start: weights, maxIterations };
  const found = yield { view, targets, options, done };
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

/** The centroids that are inside and free, and how far at most they are, in widths of cells. */
function movedToCentroids({ view, rings, places, targets }: Search): {
  places: Float64Array;
  far: number;
} {
  const perTarget = momentsOf(rings).area / targets.reduce((sum, target) => sum + target, 0);
  const centroids = view.cellCentroids();
  const result = places.slice();
  const taken = new Taken();
  for (let k = 0; k < places.length; k += 2) taken.add(places[k]!, places[k + 1]!);
  let far = 0;
  targets.forEach((target, k) => {
    const x = centroids[2 * k]!;
    const y = centroids[2 * k + 1]!;
    if (taken.has(x, y) || !isInside(rings, x, y)) return;
    taken.add(x, y);
    const dx = x - places[2 * k]!;
    const dy = y - places[2 * k + 1]!;
    far = Math.max(far, Math.sqrt((dx * dx + dy * dy) / (perTarget * target)));
    result[2 * k] = x;
    result[2 * k + 1] = y;
  });
  return { places: result, far };
}
