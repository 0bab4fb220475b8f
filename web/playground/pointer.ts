// Where the pointer is, and what is answered there: the nearest circle, which is highlighted, and
// what else the visitor asks for.
import type { Circle } from "./model/circle.js";
import type { Model } from "./model/model.js";
import { neighborsOf } from "./model/neighbors.js";
import { signal } from "./model/signals.js";
import type { Hover } from "./picture/overlay_layer.js";
import type { Painter } from "./picture/painter.js";
import type { View } from "./picture/view.js";

/** A place in pixels. */
export type Point = { x: number; y: number };
/** Answers that the visitor wants at the pointer; `nearest`: how many of the nearest circles. */
export type Questions = { neighbors: boolean; empty: boolean; under: boolean; nearest: number };

const kNothing = new Uint32Array(0);

export class Pointer {
  /** Where it is, or null while it is elsewhere. */
  at: Point | null = null;
  readonly #questions = signal<Questions>({
    neighbors: true,
    empty: false,
    under: false,
    nearest: 0,
  });
  readonly #hover = signal<Hover | null>(null);

  constructor(
    readonly model: Model,
    readonly view: View,
    readonly painter: Painter,
  ) {}

  /** The answers at the pointer. */
  get hover() {
    return this.#hover.value;
  }

  get questions() {
    return this.#questions.value;
  }

  ask(questions: Partial<Questions>) {
    this.#questions.value = { ...this.questions, ...questions };
    this.refresh();
  }

  /** Highlights the site nearest to a pixel; null: the pointer has left. */
  moveTo(at: Point | null) {
    this.at = at;
    this.refresh();
  }

  /** Answers anew: the pointer, the view or the circles may have changed. */
  refresh() {
    const hover = this.at ? this.#answers(this.at) : null;
    this.painter.overlay.hover = hover;
    this.painter.redrawOverlay();
    this.#hover.value = hover;
  }

  /**
   * The circles at a pixel, those that contain it and those that it misses by `reach` pixels: the
   * nearest one first, which is what hovering highlights. Hidden ones only if they are shown.
   */
  circlesAt(x: number, y: number, reach: number): number[] {
    const { view, painter } = this;
    const { sites, diagram } = this.model;
    const near = diagram.within(view.toWorldX(x), view.toWorldY(y), reach / view.scale);
    const found = Array.from(near);
    return painter.layers.hidden ? found : found.filter((id) => !sites.isHidden(id));
  }

  #answers({ x, y }: Point): Hover | null {
    const { questions } = this;
    const { sites, diagram } = this.model;
    const [wx, wy] = [this.view.toWorldX(x), this.view.toWorldY(y)];
    const nearest = diagram.nearest(wx, wy);
    if (!nearest) return null;
    const { id, distance } = nearest;
    return {
      x,
      y,
      id,
      distance,
      neighbors: questions.neighbors ? neighborsOf(sites, id) : kNothing,
      nearest: questions.nearest > 0 ? diagram.kNearest(wx, wy, questions.nearest) : kNothing,
      under: questions.under ? diagram.within(wx, wy, 0) : kNothing,
      empty: questions.empty ? this.#emptyNear(id, wx, wy) : null,
    };
  }

  /** The empty circle about the corner of this cell that is nearest to a point. */
  #emptyNear(id: number, wx: number, wy: number): Circle | null {
    const { view } = this;
    const { sites, diagram } = this.model;
    const [left, right] = [view.toWorldX(-view.width), view.toWorldX(2 * view.width)];
    const [bottom, top] = [view.toWorldY(2 * view.height), view.toWorldY(-view.height)];
    const cell = diagram.voronoi([left, bottom, right, top]).cellCurves(id);
    if (!cell) return null;
    const site = sites.site(id);
    let best: Circle | null = null;
    let least = Infinity;
    for (let k = 0; k < cell.neighbors.length; k++) {
      const before = k === 0 ? cell.neighbors.length - 1 : k - 1;
      if (cell.neighbors[k] < 0 || cell.neighbors[before] < 0) continue;
      const [x, y] = cell.curves.subarray(7 * k, 7 * k + 2);
      const distance = Math.hypot(x - wx, y - wy);
      if (distance >= least) continue;
      least = distance;
      best = { x, y, r: Math.hypot(x - site.x, y - site.y) - site.r };
    }
    return best;
  }
}
