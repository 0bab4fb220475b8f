// Pages of the reference: examples that run below their code, and the calls at the side, of which
// the one that is read is marked.

/** Makes cards of elements, which run (web/recipes/cards.ts). */
type StartCards = (elements: Iterable<HTMLElement>) => void;

/** Puts the card with an example's program (tools/site/recipes.mjs) behind its code. */
function run(button: HTMLButtonElement, startCards: StartCards): void {
  const code = button.parentElement as HTMLElement;
  const template = code.querySelector<HTMLTemplateElement>("template.program");
  if (!template) return;
  button.disabled = true;
  const card = document.importNode(template.content, true).firstElementChild as HTMLElement;
  code.after(card);
  startCards([card]);
}

/** Opens the list beside the page where there is room, and marks the call that is read. */
function startSide(side: HTMLElement): void {
  const details = side.querySelector("details") as HTMLDetailsElement;
  const wide = matchMedia("(min-width: 1100px)");
  const adapt = () => {
    details.open = wide.matches;
  };
  wide.addEventListener("change", adapt);
  adapt();
  const links = new Map(
    [...side.querySelectorAll<HTMLAnchorElement>(".calls a")].map((link) => [
      decodeURIComponent(link.hash.slice(1)),
      link,
    ]),
  );
  const headings = [...links.keys()].flatMap((id) => document.getElementById(id) ?? []);
  let marked: HTMLAnchorElement | undefined;
  const mark = () => {
    const top = parseFloat(getComputedStyle(document.documentElement).scrollPaddingTop) + 8;
    const read = headings.findLast((one) => one.getBoundingClientRect().top <= top);
    const link = read && links.get(read.id);
    if (link === marked) return;
    marked?.removeAttribute("aria-current");
    link?.setAttribute("aria-current", "true");
    marked = link;
    if (link && wide.matches) {
      // Within the list only: scrollIntoView would move the page, too.
      const [box, own] = [side.getBoundingClientRect(), link.getBoundingClientRect()];
      if (own.top < box.top || own.bottom > box.bottom)
        side.scrollTop += own.top - box.top - box.height / 2;
    }
  };
  let isAsked = false;
  addEventListener(
    "scroll",
    () => {
      if (isAsked) return;
      isAsked = true;
      requestAnimationFrame(() => {
        isAsked = false;
        mark();
      });
    },
    { passive: true },
  );
  mark();
}

export function startReference(startCards: StartCards): void {
  const side = document.querySelector<HTMLElement>("nav.side");
  if (side) startSide(side);
  for (const button of document.querySelectorAll<HTMLButtonElement>(".code > button.run"))
    button.addEventListener("click", () => run(button, startCards));
}
