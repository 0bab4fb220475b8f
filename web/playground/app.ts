// The page's actions, whoever asks for them: pointer, keyboard, buttons or a test. Keeps model,
// picture and selection together.
import { Camera } from "./camera.js";
import { Edits } from "./edits.js";
import { type Change, Model } from "./model/model.js";
import { Selection } from "./model/selection.js";
import { effect, signal } from "./model/signals.js";
import type { Overlay } from "./picture/overlay_layer.js";
import { type Canvases, Painter } from "./picture/painter.js";
import type { Layers } from "./picture/picture.js";
import { regionOf } from "./picture/regions.js";
import { View } from "./picture/view.js";
import { Pointer } from "./pointer.js";

const kMostBoxes = 12; // circles that change at once and are redrawn in a box

export class App {
  readonly model = new Model();
  readonly selection = new Selection(this.model);
  readonly view = new View();
  readonly painter: Painter;
  readonly pointer: Pointer;
  readonly camera: Camera;
  readonly edits: Edits;
  readonly #tool = signal({ id: "select" });

  constructor(canvases: Canvases) {
    this.painter = new Painter(canvases, this.model, this.view);
    this.pointer = new Pointer(this.model, this.view, this.painter);
    this.camera = new Camera(this.model, this.view, this.pointer);
    this.edits = new Edits(this);
    this.model.on("before", (change) => this.#redrawAround(change));
    this.model.on("change", (change) => {
      if (change.isSet) this.painter.forget();
      this.#redrawAround(change);
      this.pointer.refresh();
    });
    effect(() => this.mark({ selected: this.selection.ids }));
  }

  get diagram() {
    return this.model.diagram;
  }

  get sites() {
    return this.model.sites;
  }

  /** The id of the chosen tool (tools/registry.ts). */
  get tool() {
    return this.#tool.value.id;
  }

  /** Choosing the same one again counts, too: it ends what is under way. */
  set tool(id: string) {
    this.#tool.value = { id };
  }

  /** @param change about to happen, or just happened */
  #redrawAround({ ids }: Change) {
    const { dual, hull, vertices, levels, centres } = this.painter.layers;
    const isAround = hull || vertices || levels || centres; // what is drawn changes elsewhere, too
    if (ids === null || ids.length > kMostBoxes || isAround) {
      this.painter.redraw();
      return;
    }
    for (let k = 0; k < ids.length; k++)
      if (this.diagram.has(ids[k]))
        this.painter.redrawBox(regionOf(this.sites, this.view, ids[k], dual));
  }

  /** Draws something else over the picture. */
  mark(overlay: Partial<Overlay>) {
    Object.assign(this.painter.overlay, overlay);
    this.painter.redrawOverlay();
  }

  setLayer(name: keyof Layers, isShown: boolean) {
    this.painter.setLayer(name, isShown);
  }
}
