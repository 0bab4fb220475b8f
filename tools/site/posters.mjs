// Draws the first picture of figures where the site is built, as SVG: what readers see before any
// script has come.
import { readdirSync } from "node:fs";
import path from "node:path";
import { root } from "../toolchain/folders.mjs";

/** The modules of figures by name, which run in Node as in a browser; the playground's; the pen. */
export async function figureModules() {
  const { createServer } = await import("vite");
  const dist = path.join(root, "dist/esm");
  const server = await createServer({
    root: path.join(root, "web"),
    configFile: false,
    appType: "custom",
    logLevel: "warn",
    server: { middlewareMode: true, watch: null, ws: false },
    optimizeDeps: { noDiscovery: true },
    oxc: { target: "es2022" },
    resolve: {
      alias: [
        { find: /^apollonius-diagram$/, replacement: path.join(dist, "index.js") },
        { find: /^apollonius-diagram\/(\w+)$/, replacement: path.join(dist, "$1.js") },
      ],
    },
  });
  const figures = {};
  for (const file of readdirSync(path.join(root, "web/figures")).filter((one) => /ts$/.test(one)))
    figures[file.slice(0, -3)] = await server.ssrLoadModule(`/figures/${file}`);
  const { SvgPen } = await server.ssrLoadModule("/figure/svg_pen.ts");
  const playground = await server.ssrLoadModule("/playground/poster.ts");
  await server.close();
  return { SvgPen, playground, figures };
}

/**
 * @returns {Promise<Map<string, string>>} by the name of the figure and the window, "-wide" or
 *   "-narrow", and the playground's
 */
export async function drawPosters() {
  const { SvgPen, playground, figures } = await figureModules();
  const posters = new Map();
  for (const [name, { size, draw }] of Object.entries(playground)) {
    const pen = new SvgPen(name, ...size);
    draw(pen);
    posters.set(`playground-${name}`, pen.toSvg());
  }
  for (const [name, { default: figure }] of Object.entries(figures)) {
    if (!figure) continue; // a module that figures share
    for (const [kind, size] of Object.entries(figure.size)) {
      const pen = new SvgPen(`${name}-${kind}`, ...size);
      figure.draw(pen, figure.start(size, kind === "narrow"));
      posters.set(`${name}-${kind}`, pen.toSvg(kind));
    }
  }
  return posters;
}
