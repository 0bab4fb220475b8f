// A plugin for Vite: each page says in its head what its script will ask for, so that the browser
// fetches all of it at once: the first figure, or the playground's parts, and the WebAssembly.
import { readFileSync } from "node:fs";
import path from "node:path";
import { root } from "../toolchain/folders.mjs";

/** The end of the name of the module that a page's script imports first, or null. */
function firstModule(html, folder) {
  if (folder === "playground") return "playground/start.ts";
  const figure = /data-figure="(\w+)"/.exec(html)?.[1];
  return figure ? `figures/${figure}.ts` : null;
}

/** The parts of the WebAssembly that a module of the site needs beside `core`, as it says. */
function neededBy(module) {
  const source = readFileSync(path.join(root, "web", module), "utf8");
  const needs = /^ {2}needs: (\[.*\]),$/m.exec(source)?.[1];
  return needs === undefined ? ["shapes"] : JSON.parse(needs);
}

/** The chunk with a module, and all that it imports. */
function chunksFor(bundle, module) {
  const chunks = Object.values(bundle).filter(({ type }) => type === "chunk");
  const first = chunks.find(({ facadeModuleId }) => facadeModuleId?.endsWith(module));
  const reached = new Set();
  const visit = (name) => {
    if (reached.has(name)) return;
    reached.add(name);
    for (const imported of bundle[name]?.imports ?? []) visit(imported);
  };
  if (first) visit(first.fileName);
  return [...reached];
}

export const preloads = {
  name: "preloads",
  transformIndexHtml: {
    order: "post",
    handler(html, { bundle, path: page }) {
      const folder = path.posix.dirname(page).slice(1);
      const module = bundle && firstModule(html, folder);
      if (!module) return html;
      const up = folder === "" ? "./" : "../".repeat(folder.split("/").length);
      const parts = ["core", ...neededBy(module)].map((part) =>
        Object.keys(bundle).find((name) => path.posix.basename(name).startsWith(`${part}-`)),
      );
      const modules = chunksFor(bundle, module).filter((name) => !html.includes(name));
      return [
        ...modules.map((name) => ({ rel: "modulepreload", href: up + name })),
        ...parts.map((wasm) => ({
          rel: "preload",
          as: "fetch",
          type: "application/wasm",
          href: up + wasm,
        })),
      ].map((link) => ({
        tag: "link",
        attrs: { ...link, crossorigin: true },
        injectTo: "head",
      }));
    },
  },
};
