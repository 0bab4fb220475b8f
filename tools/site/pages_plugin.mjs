// A plugin for Vite: gives it a page of HTML for each web/pages/*.md, with the first picture of
// each page already in it.
import { readFileSync } from "node:fs";
import path from "node:path";
import { root } from "../toolchain/folders.mjs";
import { documents } from "./documents.mjs";
import { layout } from "./layout.mjs";
import { kPages } from "./list.mjs";
import { htmlOf } from "./markdown.mjs";
import { drawPosters } from "./posters.mjs";

const web = path.join(root, "web");

export async function pagesPlugin() {
  const pages = [
    ...kPages.map((page) => ({ ...page, file: path.join(web, `pages/${page.key}.md`) })),
    ...documents(),
  ];
  /** The page that a file of HTML stands for, which is nowhere on disk. */
  const byHtml = new Map(pages.map((page) => [path.join(web, page.folder, "index.html"), page]));
  let posters = new Map();
  return {
    name: "pages",
    api: {
      inputs: Object.fromEntries([...byHtml].map(([file, page]) => [page.key, file])),
    },
    async buildStart() {
      posters = await drawPosters();
    },
    transformIndexHtml: {
      order: "pre",
      handler: (html) =>
        html.replace(/<!-- poster: ([\w-]+) -->/g, (_, name) => posters.get(name) ?? ""),
    },
    resolveId: (id) => (byHtml.has(id) ? id : null),
    load(id) {
      const page = byHtml.get(id);
      if (!page) return null;
      if (page.file) this.addWatchFile(page.file);
      const text = page.text ?? readFileSync(page.file, "utf8");
      return layout(page, htmlOf(page, text, posters), pages);
    },
  };
}
