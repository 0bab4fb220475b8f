// Cards with a program to change, and what it shows: those of the page "Recipes", and examples of
// the reference. A program runs in a sandbox (frame.html), anew each time, when its card is first
// seen and when that is asked for. A changed program ends when it has computed for some seconds
// (limited_time.ts).
import { version } from "../../package.json";
import { make } from "../shared/dom.js";
import { messageOf } from "../shared/errors.js";
import theme from "../theme.css?raw";
import style from "./frame.css?raw";

const site = new URL(document.documentElement.dataset.root ?? "./", location.href);

const kNear = "100px"; // below the window
/** ms until something is said of a program that goes on; one that computes is stopped by then. */
const kPatience = 8000;
const kParts = ["core", "shapes", "sphere", "treemap"];
/** The entries of the package, and with them what these import. */
const kEntries = ["index", ...kParts, "diagnostics"];
const kFiles = [...kEntries, "embedded", "errors", ...kParts.map((part) => `${part}/part`)];

/** Messages of a sandbox. */
type Told =
  | { kind: "ready" }
  | { kind: "done" }
  | { kind: "print"; text: string }
  | { kind: "height"; height: number }
  | { kind: "failed"; message: string; line?: number };

const nameOf = (file: string) =>
  file === "index" ? "apollonius-diagram" : `apollonius-diagram/${file}`;

/**
 * The package's modules by name, as text: a sandbox has no origin, and may fetch nothing. Their
 * relative imports become imports by name.
 */
async function loadModules(): Promise<Record<string, string>> {
  const folder = new URL("lib/apollonius-diagram/", site);
  const load = async (file: string) => {
    const address = new URL(`${file}.js`, folder);
    // Once more if it fails: a network that changes drops what is being loaded.
    const response = await fetch(address).catch(() => fetch(address));
    if (!response.ok) throw new Error(`${file}.js of the package cannot be loaded`);
    const named = (_: string, before: string, to: string) =>
      `${before}"${nameOf(new URL(to, address).href.slice(folder.href.length))}"`;
    const text = await response.text();
    return [nameOf(file), text.replace(/(from|import)"(\.{1,2}\/[\w./]+)\.js"/g, named)];
  };
  return Object.fromEntries(await Promise.all(kFiles.map(load)));
}
let modules: Promise<Record<string, string>> | null = null;

const kAddress = `https://cdn.jsdelivr.net/npm/apollonius-diagram@${version}/dist/esm/`;

/**
 * A program as a page that needs no other file of its own: with the style of the sandbox, and the
 * package of this version from its address.
 */
function pageOf(title: string, program: string): string {
  const entries = kEntries.map((file) => [nameOf(file), `${kAddress}${file}.js`]);
  const map = JSON.stringify({ imports: Object.fromEntries(entries) }, null, 2);
  const head = make("title", { textContent: title }).outerHTML;
  return `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
${head}
<style>
${(theme + style).trimEnd()}
</style>
<script type="importmap">
${map}
</script>
<body>
<script type="module">
${program.trimEnd()}
</script>
`;
}

/** The program of a card, to be run. The parser comes with the first program that is changed. */
async function limited({ value, defaultValue }: HTMLTextAreaElement): Promise<string> {
  if (value === defaultValue) return value;
  const { withLimitedTime } = await import("./limited_time.js");
  return withLimitedTime(value);
}

class Card {
  readonly #code: HTMLTextAreaElement;
  readonly #result: HTMLElement;
  readonly #printed = make("pre", { className: "printed", tabIndex: 0, role: "log" });
  readonly #failed = make("p", { className: "failed", role: "alert" });
  readonly #title: string;
  #frame: HTMLIFrameElement | null = null;
  #height = "";
  #waiting = 0;

  /** @param element as tools/site/recipes.mjs makes it */
  constructor(readonly element: HTMLElement) {
    const find = <E extends HTMLElement>(selector: string) => {
      const found = element.querySelector<E>(selector);
      if (!found) throw new Error(`a recipe has no ${selector}`);
      return found;
    };
    this.#code = find("textarea");
    this.#result = find(".result");
    this.#title = this.#code.getAttribute("aria-label") ?? "";
    this.#printed.setAttribute("aria-label", "Printed");
    this.#result.append(this.#failed, this.#printed);
    this.#printed.hidden = this.#failed.hidden = true;
    find(".run").addEventListener("click", () => this.run());
    find(".reset").addEventListener("click", () => {
      this.#code.value = this.#code.defaultValue;
      this.#fit();
      this.run();
    });
    const copy = find(".copy-page");
    copy.addEventListener("click", async () => {
      const title = this.#title.replace("Program: ", "");
      await navigator.clipboard.writeText(pageOf(title, this.#code.value));
      copy.textContent = "Copied";
    });
    this.#code.addEventListener("input", () => this.#fit());
    this.#code.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" || !(event.ctrlKey || event.metaKey)) return;
      event.preventDefault();
      this.run();
    });
    addEventListener("message", ({ source, data }: MessageEvent<Told>) => {
      if (this.#frame && source === this.#frame.contentWindow) this.#hear(data);
    });
  }

  #fit() {
    this.#code.rows = this.#code.value.split("\n").length;
  }

  run() {
    this.#frame?.remove();
    this.#printed.textContent = "";
    this.#printed.hidden = true;
    this.#say("");
    this.element.dataset.state = "running"; // for tests
    this.#frame = make("iframe", { title: this.#title.replace("Program", "Result") });
    this.#frame.setAttribute("sandbox", "allow-scripts");
    this.#frame.style.height = this.#height;
    this.#frame.src = new URL("recipes/frame.html", site).href;
    this.#result.prepend(this.#frame);
    clearTimeout(this.#waiting);
    this.#waiting = window.setTimeout(() => {
      if (this.element.dataset.state === "running")
        this.#say("It has not ended yet. If it never does, reload this page.");
    }, kPatience);
  }

  async #start() {
    const frame = this.#frame;
    try {
      modules ??= loadModules();
      const program = await limited(this.#code);
      const data = { modules: await modules, style: theme + style, program };
      frame?.contentWindow?.postMessage(data, "*"); // the sandbox has no origin to name
    } catch (error) {
      modules = null; // there is another try with the next run
      this.#fail(messageOf(error));
    }
  }

  #fail(message: string, line?: number) {
    this.element.dataset.state = "failed";
    this.#say(line ? `Line ${line}: ${message}` : message);
  }

  #say(text: string) {
    this.#failed.textContent = text;
    this.#failed.hidden = text === "";
  }

  #hear(told: Told) {
    if (told.kind === "ready") this.#start();
    else if (told.kind === "failed") this.#fail(told.message, told.line);
    else if (told.kind === "print") {
      this.#printed.append(`${told.text}\n`);
      this.#printed.hidden = false;
    } else if (told.kind === "height") {
      this.#height = `${told.height}px`;
      if (this.#frame) this.#frame.style.height = this.#height;
    } else if (this.element.dataset.state === "running") {
      this.element.dataset.state = "done";
      this.#say("");
    }
  }
}

/** Makes cards of the page's recipes; each runs when it comes into view. */
export function startCards(elements: Iterable<HTMLElement>) {
  const cards = new Map<Element, Card>();
  const seen = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        if (!isIntersecting) continue;
        seen.unobserve(target);
        cards.get(target)?.run();
      }
    },
    { rootMargin: kNear },
  );
  for (const element of elements) {
    cards.set(element, new Card(element));
    seen.observe(element);
  }
}
