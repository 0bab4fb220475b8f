// Paragraphs beside a figure that tell it in steps: the one that a reader has scrolled to sets the
// figure's step, and the paragraph of the figure's step is marked.

/** A paragraph is read when it crosses a line at this height of the window. */
const kLine = { beside: 50, below: 72 }; // percent; where the figure is above, it covers more
const kBeside = "(min-width: 1000px)"; // as in site.css

export class Paragraphs {
  readonly #all: HTMLElement[];
  #observer: IntersectionObserver | null = null;

  /** @param reached is called with the step of the paragraph that is being read */
  constructor(
    group: HTMLElement | null,
    readonly reached: (step: number) => void,
  ) {
    this.#all = [...(group?.querySelectorAll<HTMLElement>("[data-step]") ?? [])];
    if (this.#all.length === 0) return;
    // The figure stops below the bar, which has two rows or three on a phone.
    const bar = document.querySelector(".bar");
    if (bar) {
      const sizes = new ResizeObserver(() => {
        const height = bar.getBoundingClientRect().height;
        group?.style.setProperty("--above", `${Math.round(height)}px`);
      });
      sizes.observe(bar);
    }
    const media = matchMedia(kBeside);
    media.addEventListener("change", () => this.#watch(media.matches));
    this.#watch(media.matches);
  }

  #watch(isBeside: boolean) {
    this.#observer?.disconnect();
    const line = isBeside ? kLine.beside : kLine.below;
    this.#observer = new IntersectionObserver(
      (entries) => {
        for (const { target, isIntersecting } of entries)
          if (isIntersecting) this.reached(Number((target as HTMLElement).dataset.step));
      },
      { rootMargin: `-${line}% 0px -${99 - line}% 0px` },
    );
    for (const paragraph of this.#all) this.#observer.observe(paragraph);
  }

  /** Marks the paragraph of a step. */
  mark(step: number) {
    for (const paragraph of this.#all) {
      if (Number(paragraph.dataset.step) === step) paragraph.setAttribute("aria-current", "step");
      else paragraph.removeAttribute("aria-current");
    }
  }
}
