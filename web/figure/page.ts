// The script of each page of the site: starts a figure when it comes near the window, and shows its
// source when that is asked for.
import { make } from "../shared/dom.js";
import { messageOf } from "../shared/errors.js";
import { whenLoaded } from "../shared/package.js";
import type { AnyFigure } from "./figure.js";
import { FigureRunner } from "./runner.js";
import { startSearch } from "./search.js";

const kNear = "300px"; // below the window

const modules = import.meta.glob<{ default: AnyFigure }>("../figures/*.ts");
const sources = import.meta.glob<string>("../figures/*.ts", { query: "?raw", import: "default" });

const runners = new Map<string, FigureRunner<unknown>>();

async function start(element: HTMLElement) {
  const name = element.dataset.figure ?? "";
  try {
    const [{ default: figure }] = await Promise.all([
      modules[`../figures/${name}.ts`](),
      whenLoaded([]),
    ]);
    await whenLoaded(figure.needs ?? ["shapes"]);
    runners.set(name, new FigureRunner(element, figure, name));
    listenToSource(element, name);
  } catch (error) {
    console.error(error);
    const text = `This figure could not be started: ${messageOf(error)}`;
    element.querySelector(".stage")?.after(make("p", { className: "failed" }, text));
    element.dataset.state = "failed";
  }
}

function listenToSource(element: HTMLElement, name: string) {
  const code = make("code");
  const details = make(
    "details",
    { className: "source" },
    make("summary", {}, "Source of this figure"),
    make("pre", { tabIndex: 0 }, code),
  );
  details.addEventListener("toggle", async () => {
    if (details.open) code.textContent ||= await sources[`../figures/${name}.ts`]();
  });
  element.append(details);
}

const near = new IntersectionObserver(
  (entries) => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      near.unobserve(target);
      const element = target.closest<HTMLElement>("figure");
      if (element) start(element);
    }
  },
  { rootMargin: kNear },
);
// Their stages: in `.steps` a figure itself may have no box.
for (const stage of document.querySelectorAll("figure[data-figure] .stage")) near.observe(stage);

for (const button of document.querySelectorAll<HTMLButtonElement>("button.copy"))
  button.addEventListener("click", async () => {
    await navigator.clipboard.writeText(
      button.parentElement?.querySelector("code")?.textContent ?? "",
    );
    button.textContent = "Copied";
  });

const recipes = document.querySelectorAll<HTMLElement>(".recipe");
const startCards = async (elements: Iterable<HTMLElement>) =>
  (await import("../recipes/cards.js")).startCards(elements);
if (recipes.length > 0) startCards(recipes);

if (document.querySelector("nav.side"))
  import("./reference.js").then(({ startReference }) => startReference(startCards));

const search = document.querySelector<HTMLElement>("button.search");
if (search) startSearch(search);

// A handle for tests and the curious; not an interface.
Object.assign(window, { figures: runners });
