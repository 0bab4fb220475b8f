// The panel beside the diagram and the card of the selected site: numbers out, buttons in.

const kFewest = 8; // queries before their mean time is worth showing
const kAnnounceAfter = 400; // ms: a screen reader hears where a movement ended, not every step

const element = (id) => document.getElementById(id);
const whole = new Intl.NumberFormat("en", { maximumFractionDigits: 0 });
const grouped = (n) => whole.format(n).replaceAll(",", "\u202f");

/** Three significant digits, without an exponent where that reads well. */
export function short(value) {
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e7))
    return value.toExponential(2).replace("-", "\u2212");
  const digits = size >= 100 || size === 0 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3;
  return groupedText(value.toFixed(digits));
}

function groupedText(text) {
  const [integer, fraction] = text.replace("-", "\u2212").split(".");
  const head = integer.replace(/\B(?=(\d{3})+(?!\d))/g, "\u202f");
  return fraction ? `${head}.${fraction}` : head;
}

/** @param {number} micros */
export function duration(micros) {
  if (micros >= 1e4) return `${(micros / 1000).toFixed(0)} ms`;
  if (micros >= 1e3) return `${(micros / 1000).toFixed(1)} ms`;
  return `${micros.toFixed(micros < 10 ? 1 : 0)} µs`;
}

export class Panel {
  /** Unit of lengths after numbers. */
  unit = "";
  #frame = 0;
  #announcement = 0;
  #texts = new Map();

  /**
   * @param {import("./app.js").App} app
   * @param {{ cities(): void, random(count: number, share: number): void, clear(): void, fit():
   * void }} actions
   */
  constructor(app, actions) {
    this.app = app;
    for (const type of ["change", "hover", "select"])
      app.addEventListener(type, () => this.#request());
    app.addEventListener("select", () => this.#announceSelection());
    this.#listen(actions);
    this.#request();
  }

  #listen(actions) {
    const { app } = this;
    const share = /** @type {HTMLInputElement} */ (element("share"));
    share.addEventListener("input", () => {
      element("share-value").textContent = `${share.value} %`;
    });
    /** @type {NodeListOf<HTMLElement>} */
    const counts = document.querySelectorAll("[data-count]");
    for (const button of counts) {
      button.addEventListener("click", () =>
        actions.random(Number(button.dataset.count), Number(share.value) / 100),
      );
    }
    element("set-cities").addEventListener("click", () => actions.cities());
    element("clear").addEventListener("click", actions.clear);
    element("fit").addEventListener("click", actions.fit);
    element("layers").addEventListener("change", (event) => {
      const { name, checked } = /** @type {HTMLInputElement} */ (event.target);
      app.setLayer(name, checked);
    });
    element("fold").addEventListener("click", () =>
      this.fold(!element("panel").classList.contains("folded")),
    );
    const grow = (factor) => {
      if (app.selected < 0) return;
      const { r } = app.scene.site(app.selected);
      app.resize(app.selected, Math.max(r, 1 / app.view.scale) * factor);
    };
    element("card-larger").addEventListener("click", () => grow(1.15));
    element("card-smaller").addEventListener("click", () => grow(1 / 1.15));
    element("card-delete").addEventListener(
      "click",
      () => app.selected >= 0 && app.remove(app.selected),
    );
    element("card-close").addEventListener("click", () => app.select(-1));
  }

  /** Hides the controls where there is little room. */
  fold(folded) {
    element("panel").classList.toggle("folded", folded);
    element("fold").setAttribute("aria-expanded", String(!folded));
  }

  /** Whether the map's switch and credit are there. */
  showsMap(shown) {
    element("map-layer").hidden = !shown;
    element("credit").hidden = !shown;
  }

  #request() {
    if (!this.#frame) this.#frame = requestAnimationFrame(() => this.#update());
  }

  /** Sets a text if it has changed: the browser lays out nothing else. */
  #text(id, text) {
    if (this.#texts.get(id) === text) return;
    this.#texts.set(id, text);
    element(id).textContent = text;
  }

  #update() {
    this.#frame = 0;
    const { diagram, scene, hover } = this.app;
    this.#text("count-all", grouped(diagram.size));
    this.#text("count-visible", grouped(diagram.visibleSize));
    this.#text("count-hidden", grouped(diagram.hiddenSize));
    if (hover) {
      const { name, detail } = scene.label(hover.id);
      this.#text("nearest-name", name);
      this.#text(
        "nearest-detail",
        this.#distance(hover.distance) + (detail ? ` · ${detail.split(" · ")[0]}` : ""),
      );
    } else {
      this.#text("nearest-name", "–");
      this.#text(
        "nearest-detail",
        diagram.size ? "Move over the diagram" : "Click to insert a circle",
      );
    }
    const { operation, count, micros } = scene.timing;
    const verb = { insert: "Insert", update: "Update", remove: "Remove" }[operation];
    if (verb)
      this.#text(
        "timing",
        `${verb}${count === 1 ? "" : ` ${grouped(count)}`}: ${duration(micros)}`,
      );
    const { query } = this.app;
    this.#text("query", query.count >= kFewest ? `Nearest: ${duration(query.micros)}` : "");
    this.#updateCard();
  }

  #distance(distance) {
    const unit = this.unit && ` ${this.unit}`;
    return `${short(Math.abs(distance))}${unit} ${distance < 0 ? "inside" : "away"}`;
  }

  #updateCard() {
    const { selected, scene } = this.app;
    element("card").hidden = selected < 0;
    if (selected < 0) return;
    const { name, detail } = scene.label(selected);
    const { x, y, r } = scene.site(selected);
    this.#text("card-name", name);
    this.#text("card-detail", detail ?? "");
    this.#text(
      "card-numbers",
      `(${short(x)}, ${short(y)}) · r ${short(r)} · ${this.#state(selected)}`,
    );
  }

  #state(id) {
    const { diagram, scene } = this.app;
    if (diagram.isHidden(id)) return `hidden inside ${scene.label(diagram.coverOf(id)).name}`;
    const count = diagram.neighbors(id).length;
    return `${grouped(count)} neighbour${count === 1 ? "" : "s"}`;
  }

  #announceSelection() {
    const { selected, scene } = this.app;
    this.announce(
      selected < 0
        ? "Nothing selected"
        : `${scene.label(selected).name} selected, ${this.#state(selected)}`,
    );
  }

  announce(text) {
    clearTimeout(this.#announcement);
    this.#announcement = setTimeout(
      () => (element("announcer").textContent = text),
      kAnnounceAfter,
    );
  }
}
