// Lets a figure live on its page: canvas, controls, handles, pointer, touch and keyboard, the text
// that says what is seen, light and dark, motion.
import { contextOf } from "../shared/canvas.js";
import { make } from "../shared/dom.js";
import { arrowOf, placeIn } from "../shared/input.js";
import { isDue } from "../shared/pace.js";
import { readTheme, whenThemeChanges } from "../shared/theme.js";
import { CanvasPen } from "./canvas_pen.js";
import { makeControls } from "./controls.js";
import type { Figure, Said, Size } from "./figure.js";
import { Handles } from "./handles.js";
import { playgroundLink } from "./playground_link.js";
import { Paragraphs } from "./steps.js";

const kNarrow = 520; // CSS pixels
const kCursorStep = 12; // CSS pixels that an arrow key moves the pointer by
const kLongestStep = 0.05; // seconds between two frames, at most
const kQuietTime = 700; // ms without a change after which a text is read aloud

const reduced = matchMedia("(prefers-reduced-motion: reduce)");

export class FigureRunner<State> {
  readonly canvas = make("canvas", { ariaHidden: "true" });
  readonly stage: HTMLElement;
  readonly #context = contextOf(this.canvas);
  readonly #text = make("p", { className: "said" });
  readonly #code = make("code");
  readonly #aloud = make("p", { className: "visually-hidden", ariaLive: "polite" });
  readonly #controls: { element: HTMLElement; update(): void };
  readonly #handles: Handles;
  readonly #paragraphs: Paragraphs;
  #size: Size;
  #isNarrow = false;
  #scale = 1;
  #theme = readTheme();
  #frame = 0;
  #last = 0; // when it was drawn while it moves, else 0
  #isStale = true; // the drawing shows an older state
  #isSeen = true;
  #cursor: [number, number] | null = null;
  #quiet = 0;
  state: State;

  /** @param element the `figure` of the page, with a `.stage` and a `figcaption` */
  constructor(
    readonly element: HTMLElement,
    readonly figure: Figure<State>,
    readonly name: string,
  ) {
    const stage = element.querySelector<HTMLElement>(".stage");
    if (!stage) throw new Error(`figure ${name} has no stage`);
    this.stage = stage;
    this.#isNarrow = stage.clientWidth < kNarrow;
    this.#size = this.#sizeNow();
    this.state = figure.start(this.#size, this.#isNarrow);
    this.#handles = new Handles(stage, () => this.#changed());
    this.#controls = makeControls(
      figure.controls ?? [],
      () => this.state,
      () => this.#changed(),
    );
    for (const poster of stage.querySelectorAll(".poster")) poster.remove();
    stage.prepend(this.canvas);
    stage.after(this.#controls.element, this.#text, this.#aloud);
    if (figure.code) this.#text.before(make("pre", { className: "live-code" }, this.#code));
    this.#controls.element.append(...this.#ends());
    const { steps } = figure;
    this.#paragraphs = new Paragraphs(
      steps ? element.closest<HTMLElement>(".steps") : null,
      (step) => {
        steps?.set(this.state, step);
        this.#changed();
      },
    );
    this.#listen();
    this.#resize();
    element.dataset.state = "running"; // for the style sheet and for tests
  }

  #sizeNow() {
    return this.#isNarrow ? this.figure.size.narrow : this.figure.size.wide;
  }

  /** Reset, and the way to the playground. */
  #ends() {
    const reset = make("button", { type: "button", className: "reset" }, "Reset");
    reset.addEventListener("click", () => this.restart());
    const { circles } = this.figure;
    if (!circles) return [reset];
    const link = make("a", { className: "to-playground" }, "Open in the playground");
    link.href = playgroundLink(circles(this.state));
    const renew = () => {
      link.href = playgroundLink(circles(this.state));
    };
    for (const type of ["pointerenter", "focus", "pointerdown"] as const)
      link.addEventListener(type, renew);
    return [reset, link];
  }

  restart() {
    this.#cursor = null;
    this.state = this.figure.start(this.#size, this.#isNarrow);
    this.#changed();
  }

  #listen() {
    const { stage } = this;
    const sizes = new ResizeObserver(() => this.#resize());
    sizes.observe(stage);
    const seen = new IntersectionObserver(([entry]) => {
      this.#isSeen = entry.isIntersecting;
      if (this.#isSeen) this.#request();
    });
    seen.observe(stage);
    whenThemeChanges(() => {
      this.#theme = readTheme();
      this.#ask();
    });
    const { hover, press, drag } = this.figure;
    if (!hover && !press && !drag) return;
    const at = (event: MouseEvent): [number, number] => {
      const [x, y] = placeIn(stage, event);
      return [x / this.#scale, y / this.#scale];
    };
    if (hover) {
      const go = (event: PointerEvent) => {
        this.#cursor = at(event);
        this.#hover(this.#cursor);
      };
      stage.addEventListener("pointermove", go);
      stage.addEventListener("pointerdown", go);
      stage.addEventListener("pointerleave", (event) => {
        if (event.pointerType === "mouse") this.#hover(null); // a finger's answer stays
      });
      stage.addEventListener("blur", () => this.#hover(null));
    }
    if (press)
      stage.addEventListener("click", (event) => {
        if ((event.target as Element).closest(".handle")) return;
        press(this.state, at(event));
        this.#changed();
      });
    if (drag) this.#listenToDrag(at);
    stage.tabIndex = 0;
    stage.setAttribute("role", "application");
    stage.addEventListener("keydown", (event) => this.#key(event));
  }

  #listenToDrag(at: (event: PointerEvent) => [number, number]) {
    const { stage } = this;
    let last: [number, number] | null = null;
    stage.classList.add("can-drag");
    stage.addEventListener("pointerdown", (event) => {
      if (!event.isPrimary || event.button !== 0) return;
      if ((event.target as Element).closest(".handle")) return;
      last = at(event);
      stage.setPointerCapture(event.pointerId);
    });
    stage.addEventListener("pointermove", (event) => {
      if (!last || !event.isPrimary) return;
      const [x, y] = last;
      last = at(event);
      this.figure.drag?.(this.state, last[0] - x, last[1] - y);
      this.#changed();
    });
    for (const type of ["pointerup", "pointercancel"] as const)
      stage.addEventListener(type, () => {
        last = null;
      });
  }

  #hover(at: [number, number] | null) {
    this.figure.hover?.(this.state, at);
    this.#changed();
  }

  #key(event: KeyboardEvent) {
    if (event.target !== this.stage || event.ctrlKey || event.metaKey || event.altKey) return;
    const step = ((event.shiftKey ? 5 : 1) * kCursorStep) / this.#scale;
    const arrow = arrowOf(event.key);
    if (arrow && this.figure.drag) {
      event.preventDefault();
      // The view moves where the arrow points.
      this.figure.drag(this.state, -step * arrow[0], -step * arrow[1]);
      this.#hover(null);
      return;
    }
    const [width, height] = this.#size;
    this.#cursor ??= [width / 2, height / 2];
    if (arrow) {
      const [x, y] = this.#cursor;
      this.#cursor = [
        Math.max(0, Math.min(width, x + step * arrow[0])),
        Math.max(0, Math.min(height, y + step * arrow[1])),
      ];
    } else if (event.key === "Enter" || event.key === " ") {
      this.figure.press?.(this.state, this.#cursor);
    } else return;
    event.preventDefault();
    this.#hover(this.#cursor);
  }

  #resize() {
    const width = this.stage.clientWidth;
    if (width === 0) return;
    const isNarrow = width < kNarrow;
    if (isNarrow !== this.#isNarrow) {
      this.#isNarrow = isNarrow;
      this.#size = this.#sizeNow();
      this.state = this.figure.start(this.#size, isNarrow);
    }
    this.#scale = width / this.#size[0];
    const density = devicePixelRatio || 1;
    const height = this.#size[1] * this.#scale;
    this.stage.style.aspectRatio = `${this.#size[0]} / ${this.#size[1]}`;
    this.canvas.width = Math.round(width * density);
    this.canvas.height = Math.round(height * density);
    this.#changed();
    this.draw();
  }

  /** Something may have changed: draws and says it with the next frame. */
  #changed() {
    this.#controls.update();
    if (this.figure.steps) this.#paragraphs.mark(this.figure.steps.get(this.state));
    this.#ask();
  }

  #ask() {
    this.#isStale = true;
    this.#request();
  }

  #request() {
    if (this.#frame === 0) this.#frame = requestAnimationFrame((now) => this.#step(now));
  }

  /** A frame: what is stale is drawn at once, what only moves on when it is due and seen. */
  #step(now: number) {
    this.#frame = 0;
    if (this.#isSeen) this.#move(now);
    else this.#last = 0;
    if (this.#isStale) this.draw();
  }

  #move(now: number) {
    const { tick } = this.figure;
    if (!tick) return;
    if (!this.#isStale && !isDue(now, this.#last)) {
      this.#request();
      return;
    }
    const seconds = this.#last === 0 ? 0 : Math.min(kLongestStep, (now - this.#last) / 1000);
    const moves = tick(this.state, seconds, reduced.matches);
    // Its last step has moved it, too.
    this.#isStale ||= moves || this.#last !== 0;
    this.#last = moves ? now : 0;
    if (!moves) return;
    this.#controls.update();
    this.#request();
  }

  draw() {
    this.#isStale = false;
    const [width, height] = this.#size;
    const density = this.canvas.width / (width * this.#scale);
    const pen = new CanvasPen(this.#context, width, height, this.#scale, density, this.#theme);
    this.figure.draw(pen, this.state);
    this.#handles.place(this.figure.handles?.(this.state) ?? [], this.#scale);
    if (this.figure.code) this.#code.textContent = this.figure.code(this.state);
    this.#say(this.figure.say(this.state));
  }

  #say(said: readonly Said[]) {
    const text = said.map((part) => (typeof part === "string" ? part : part[0])).join("");
    if (text === this.#text.textContent) return;
    this.#text.replaceChildren(
      ...said.map((part) =>
        typeof part === "string" ? part : make("b", { className: `of-${part[1]}` }, part[0]),
      ),
    );
    clearTimeout(this.#quiet);
    // Only what a reader has asked for is read aloud, when it has come to rest.
    if (!this.element.contains(document.activeElement)) return;
    this.#quiet = window.setTimeout(() => {
      this.#aloud.textContent = text;
    }, kQuietTime);
  }
}
