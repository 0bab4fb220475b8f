// The same area for all: radii with which all cells are equally large, found in a worker, and let
// in little by little. That is one edit, and back again another.
import type { FitProgress } from "apollonius-diagram";
import type { App } from "../app.js";
import { signal, whenever } from "../model/signals.js";
import type { Sites, Window } from "../model/sites.js";
import type { Watch } from "../sets/building.js";
import { short } from "../ui/dom.js";
import type { FitRequest } from "./fit_worker.js";
import { inWorker, WorkerError } from "./in_worker.js";
import type { Motion } from "./motion.js";
import type { Weights } from "./weights.js";

/** What has been found: x, y, r of all circles. */
export type Found = {
  sites: Sites;
  ids: Uint32Array;
  before: Float64Array;
  after: Float64Array;
  window: Window;
};

const kMostFitted = 10_000; // circles,
const kMostOnMap = 300; // and on a map: cities crowd, 1500 of them take a minute
const kTime = 1.2; // seconds that circles take to grow or shrink
const kMargin = 0.03; // of the frame around circles
const kTolerance = 1e-6; // fitAreas's own

const newWorker = () => new Worker(new URL("./fit_worker.ts", import.meta.url), { type: "module" });
const eased = (t: number) => t * t * (3 - 2 * t);

export class SameAreas {
  #found: Found | null = null;
  readonly #isOn = signal(false);
  #isComing = false; // the circles are on their way

  constructor(
    readonly app: App,
    readonly motion: Motion,
    readonly weights: Weights,
  ) {
    app.model.on("change", () => this.#look());
    whenever(
      () => app.painter.layers,
      () => this.#look(),
    );
  }

  /** Whether the circles are those that were found, or about to be; cells end at a frame then. */
  get isOn() {
    return this.#isOn.value;
  }

  /** What has become of the radii, while it is on. */
  get radii() {
    if (!this.isOn || !this.#found) return "";
    const { before, after } = this.#found;
    const negative = radiiOf(after).filter((r) => r < 0).length;
    const said = `Radii: ${rangeOf(before)} before, ${rangeOf(after)} now.`;
    if (negative === 0) return said;
    return (
      `${said} ${negative} of ${after.length / 3} are negative, drawn as ×: cells depend on the ` +
      "differences of radii only."
    );
  }

  /** Why it cannot be had; "" if it can. */
  get hindrance() {
    const { size, info } = this.app.sites;
    if (info.map && size > kMostOnMap)
      return (
        `For up to ${kMostOnMap} circles on a map: cities crowd so much that fitting them takes ` +
        "a minute, with radii larger than the Earth’s"
      );
    if (size > kMostFitted) return `For up to ${kMostFitted.toLocaleString("en")} circles`;
    return size < 2 ? "For two circles or more" : "";
  }

  async turnOn(watch: Watch) {
    const { app } = this;
    this.motion.stop();
    this.weights.go(1, { isAtOnce: true });
    const { sites } = app;
    const before = sites.triples(sites.ids);
    const window = windowOf(app);
    const radii = await this.#radii({ xyr: before, window }, watch);
    const after = before.map((value, k) => (k % 3 === 2 ? radii[(k - 2) / 3] : value));
    this.#found = { sites, ids: sites.ids, before, after, window };
    this.#isComing = true;
    this.#move(sites.ids, before, after);
  }

  /** Back to the radii from before. */
  turnOff() {
    this.motion.stop();
    if (!this.#found) return;
    const { ids, before } = this.#found;
    this.#move(ids, this.app.sites.triples(ids), before);
  }

  /** Asks the worker; whatever changes the circles meanwhile stops it. */
  async #radii(request: FitRequest, { signal, progress }: Watch): Promise<Float64Array> {
    const controller = new AbortController();
    const stop = () => controller.abort(new DOMException("they have changed", "AbortError"));
    const listening = new AbortController();
    this.app.model.on("change", stop, { signal: listening.signal });
    signal?.addEventListener("abort", stop);
    let first = 0; // error, in the beginning,
    let least = Infinity; // and the least one so far: it need not fall with each step
    const tell = ({ iterations, error }: FitProgress) => {
      first ||= error;
      least = Math.min(least, error);
      const share = Math.log(first / least) / Math.log(first / kTolerance);
      progress?.(share, `Step ${iterations}: ${offBy(least)}`);
    };
    try {
      progress?.(undefined, "Looking for the radii");
      return await inWorker(newWorker, request, tell, controller.signal);
    } catch (error) {
      if (!(error instanceof WorkerError) || error.code !== "no-convergence") throw error;
      throw new Error(`no radii were found: ${offBy(least)}`);
    } finally {
      listening.abort();
    }
  }

  #move(ids: Uint32Array, from: Float64Array, to: Float64Array) {
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
      this.app.model.update(ids, to);
      this.#hasCome();
      return;
    }
    let t = 0;
    const step = (seconds: number) => {
      t += seconds / kTime;
      if (t < 1) return from.map((value, k) => value + (to[k] - value) * eased(t));
      queueMicrotask(() => this.motion.stop());
      return to;
    };
    this.motion.start(ids, step, () => this.#hasCome());
  }

  #hasCome() {
    this.#isComing = false;
    this.#look();
  }

  /** Shows the frame if the circles are what was found, whoever has made them so. */
  #look() {
    const { painter } = this.app;
    const frame = this.#found && (this.#isComing || this.#isThere()) ? this.#found.window : null;
    if (painter.frame === frame) return;
    painter.frame = frame;
    painter.redraw();
    this.#isOn.value = frame !== null;
  }

  #isThere() {
    const { sites } = this.app;
    if (this.#found?.sites !== sites || sites.weight !== 1) return false;
    const { ids, after, window } = this.#found;
    return (
      (!sites.info.map || window === windowOf(this.app)) &&
      sites.size === ids.length &&
      sites.ids.every((id, k) => id === ids[k]) &&
      sites.triples(ids).every((value, k) => value === after[k])
    );
  }
}

/** How far the cell that is most off is from its share. */
const offBy = (error: number) =>
  error >= 1
    ? `the most unequal cell has ${Math.round(1 + error)} times its share`
    : `areas are off by up to ${Number((100 * error).toPrecision(2))} %`;

const radiiOf = (xyr: Float64Array) => xyr.filter((_, k) => k % 3 === 2);

function rangeOf(xyr: Float64Array) {
  const [least, most] = radiiOf(xyr).reduce(
    ([low, high], r) => [Math.min(low, r), Math.max(high, r)],
    [Infinity, -Infinity],
  );
  return `${short(least)} to ${short(most)}`.replaceAll(".00", "");
}

/** What is to be shared out: the land, the map, or a frame around the circles. */
function windowOf({ sites, painter }: App): Window {
  const { map } = sites.info;
  if (map) return painter.layers.coast ? map.land.rings : map.outline.rings;
  const [xmin, ymin, xmax, ymax] = sites.bounds() ?? [0, 0, 0, 0];
  const margin = kMargin * Math.hypot(xmax - xmin, ymax - ymin) || 1;
  return [xmin - margin, ymin - margin, xmax + margin, ymax + margin];
}
