// Search over all pages of the site: a dialog, opened by its button or "/". Pagefind has made the
// index when the site was built (tools/build_site.mjs), and reads only the parts it needs.
import { make } from "../shared/dom.js";
import { messageOf } from "../shared/errors.js";

const kPages = 12;
const kPlaces = 6; // of a page

/** The part of Pagefind's interface that is used here. */
interface Pagefind {
  debouncedSearch(text: string): Promise<{ results: { data(): Promise<Found> }[] } | null>;
}
interface Place {
  title: string;
  url: string;
  /** HTML, of which the only tag is `mark`. */
  excerpt: string;
}
interface Found {
  url: string;
  meta: { title: string };
  excerpt: string;
  sub_results: Place[];
}

let pagefind: Promise<Pagefind> | null = null;

function load(): Promise<Pagefind> {
  const root = new URL(document.documentElement.dataset.root ?? "./", location.href);
  const address = new URL("pagefind/pagefind.js", root).href;
  pagefind ??= import(/* @vite-ignore */ address) as Promise<Pagefind>;
  return pagefind;
}

/** An excerpt as nodes: nothing in it but its marks is taken as HTML. */
function nodesOf(excerpt: string): Node[] {
  const { body } = new DOMParser().parseFromString(excerpt, "text/html");
  return [...body.childNodes].map((node) =>
    node.nodeName === "MARK"
      ? make("mark", {}, node.textContent ?? "")
      : new Text(node.textContent ?? ""),
  );
}

function link(url: string, title: string, excerpt: string): HTMLLIElement {
  return make(
    "li",
    {},
    make("a", { href: url }, make("b", {}, title), make("span", {}, ...nodesOf(excerpt))),
  );
}

/** The pages found, each with the places in it that fit: first those named by the word. */
function listOf(found: Found[], text: string): HTMLLIElement[] {
  const has = (title: string) => title.toLowerCase().includes(text.toLowerCase());
  return found.flatMap(({ url, meta, excerpt, sub_results }) => {
    const places = sub_results
      .filter((place) => place.url !== url && place.title !== meta.title)
      .sort((a, b) => Number(has(b.title)) - Number(has(a.title)))
      .slice(0, kPlaces);
    return [
      link(url, meta.title, excerpt),
      ...places.map((place) => {
        const item = link(place.url, place.title, place.excerpt);
        item.className = "place";
        return item;
      }),
    ];
  });
}

/** Makes the dialog; the button opens it. */
export function startSearch(button: HTMLElement): void {
  const input = make("input", { type: "search", placeholder: "find, hidden, GeoJSON, …" });
  input.setAttribute("aria-label", "Search the site");
  const list = make("ol");
  const said = make("p", { className: "said" });
  said.setAttribute("role", "status");
  const dialog = make("dialog", { className: "search" }, input, said, list);
  dialog.setAttribute("aria-label", "Search");
  document.body.append(dialog);

  const open = () => {
    if (dialog.open) return;
    dialog.showModal();
    input.select();
    load().catch(fail);
  };
  const fail = (error: unknown) => {
    pagefind = null; // there is another try with the next word
    list.replaceChildren();
    said.textContent = `The index cannot be read: ${messageOf(error)}`;
  };
  const look = async () => {
    const text = input.value.trim();
    if (text === "") {
      list.replaceChildren();
      said.textContent = "";
      return;
    }
    try {
      const search = await (await load()).debouncedSearch(text);
      if (search === null) return; // another letter has come
      const found = await Promise.all(search.results.slice(0, kPages).map((one) => one.data()));
      if (text !== input.value.trim()) return;
      list.replaceChildren(...listOf(found, text));
      const count = search.results.length;
      said.textContent = count === 0 ? `Nothing about “${text}”.` : `${count} pages`;
    } catch (error) {
      fail(error);
    }
  };
  input.addEventListener("input", look);
  button.addEventListener("click", open);
  addEventListener("keydown", (event) => {
    const isTyping = (event.target as Element).closest?.(
      "input, textarea, select, [contenteditable]",
    );
    if (event.key !== "/" || isTyping || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    open();
  });
  dialog.addEventListener("keydown", (event) => {
    const links = [...list.querySelectorAll("a")];
    const at = links.indexOf(document.activeElement as HTMLAnchorElement);
    if (event.key === "Enter" && document.activeElement === input) links[0]?.click();
    else if (event.key === "ArrowDown") links[Math.min(at + 1, links.length - 1)]?.focus();
    else if (event.key === "ArrowUp") (at > 0 ? links[at - 1] : input).focus();
    else return;
    event.preventDefault();
  });
  dialog.addEventListener("click", ({ target }) => {
    // Beside it, or on a place in this page.
    if (target === dialog || (target as Element).closest("a")) dialog.close();
  });
}
