// Draws the first picture of figures where the site is built, as SVG: what readers see before any
// script has come.
import { readdirSync } from "node:fs";
import path from "node:path";
import { root } from "../toolchain/folders.mjs";

const folder = path.join(root, "web/figures");
const made = path.join(root, "build/figures");

/** The figures, which run in Node as in a browser: they import the package and draw with a pen. */
async function bundled() {
  const { build } = await import("esbuild");
  const names = readdirSync(folder)
    .filter((file) => file.endsWith(".ts"))
    .map((file) => file.slice(0, -3));
  const contents = [
    'export { SvgPen } from "../figure/svg_pen.ts";',
    'export * as playground from "../playground/poster.ts";',
    ...names.map((name) => `export * as ${name} from "./${name}.ts";`),
  ].join("\n");
  const outfile = path.join(made, `figures-${process.pid}-${Date.now()}.mjs`);
  await build({
    stdin: { contents, resolveDir: folder, loader: "ts" },
    outfile,
    bundle: true,
    format: "esm",
    platform: "node",
    target: "node20",
    alias: {
      "apollonius-diagram": path.join(root, "dist/esm/index.js"),
      "apollonius-diagram/core": path.join(root, "dist/esm/core.js"),
      "apollonius-diagram/shapes": path.join(root, "dist/esm/shapes.js"),
      "apollonius-diagram/sphere": path.join(root, "dist/esm/sphere.js"),
      "apollonius-diagram/treemap": path.join(root, "dist/esm/treemap.js"),
    },
    logLevel: "warning",
  });
  const { rmSync } = await import("node:fs");
  const { SvgPen, playground, ...figures } = await import(outfile);
  rmSync(outfile);
  return { SvgPen, playground, figures };
}

/**
 * @returns {Promise<Map<string, string>>} by the name of the figure and the window, "-wide" or
 *   "-narrow", and the playground's
 */
export async function drawPosters() {
  const { SvgPen, playground, figures } = await bundled();
  const posters = new Map();
  for (const [name, { size, draw }] of Object.entries(playground)) {
    const pen = new SvgPen(name, ...size);
    draw(pen);
    posters.set(`playground-${name}`, pen.toSvg());
  }
  for (const [name, { default: figure }] of Object.entries(figures)) {
    if (!figure) continue; // what figures share
    for (const [kind, size] of Object.entries(figure.size)) {
      const pen = new SvgPen(`${name}-${kind}`, ...size);
      figure.draw(pen, figure.start(size, kind === "narrow"));
      posters.set(`${name}-${kind}`, pen.toSvg(kind));
    }
  }
  return posters;
}
