// The recipes of web/examples for frameworks, bundled as their users would, in the browser.
import { mkdirSync } from "node:fs";
import path from "node:path";
import { expect, test } from "@jest/globals";
import { build } from "esbuild";
import { root } from "../../tools/toolchain/folders.mjs";
import { closePage, describeInBrowser } from "./support/browser.mjs";

const pictures = path.join(root, "build/pictures");
const bubbles = [
  { x: 100, y: 80, r: 50 },
  { x: 190, y: 90, r: 15 },
  { x: 105, y: 90, r: 10 },
];

/** A script for a page, of a program that may import the examples and what they import. */
async function bundled(program) {
  const { outputFiles } = await build({
    stdin: { contents: program, resolveDir: path.join(root, "web/examples"), loader: "jsx" },
    bundle: true,
    write: false,
    format: "iife",
    jsx: "automatic",
    define: { "process.env.NODE_ENV": '"development"' },
    loader: { ".css": "empty", ".png": "empty" },
    alias: { "apollonius-diagram": path.join(root, "dist/esm/index.js") },
    logLevel: "silent",
  });
  return outputFiles[0].text;
}

describeInBrowser("recipes", (open) => {
  /** Runs a program on an empty page; keeps a picture for people to look at. */
  async function inPage(name, program, act) {
    const page = await open({ path: "examples/#comparison", ready: "example" });
    const style = "width: 700px; height: 420px";
    await page.setContent(`<div id="container" style="${style}"></div>`);
    await page.addScriptTag({ content: await bundled(program) });
    const found = await act(page);
    mkdirSync(pictures, { recursive: true });
    await page.screenshot({ path: path.join(pictures, `recipe_${name}.png`) });
    expect(page.errors).toEqual([]);
    await closePage(page);
    return found;
  }

  test("React in StrictMode: each diagram is disposed of once, the shown one lives", async () => {
    await inPage(
      "react",
      `
      import { StrictMode } from "react";
      import { flushSync } from "react-dom";
      import { createRoot } from "react-dom/client";
      import { Diagram } from "apollonius-diagram";
      import BubbleChart from "./react.jsx";

      const counts = (window.counts = { made: 0, disposed: 0, twice: 0 });
      const seen = new WeakSet();
      const { from } = Diagram;
      Diagram.from = (...list) => (++counts.made, from(...list));
      const { dispose } = Diagram.prototype;
      Diagram.prototype.dispose = function () {
        seen.has(this) ? ++counts.twice : ++counts.disposed;
        seen.add(this);
        dispose.call(this);
      };
      const root = createRoot(document.getElementById("container"));
      window.show = (bubbles) =>
        flushSync(() => root.render(<StrictMode><BubbleChart bubbles={bubbles} /></StrictMode>));
      window.end = () => root.unmount();`,
      async (page) => {
        /** Effects run some time after they are asked for. */
        const expectCounts = async (made, disposed) => {
          const isSo = ([a, b]) => window.counts.made === a && window.counts.disposed === b;
          await page.waitForFunction(isSo, [made, disposed]);
          expect(await page.evaluate(() => window.counts.twice)).toBe(0);
        };
        const red = () => page.locator('circle[fill="#e15759"]').count();
        const show = (some) => page.evaluate((given) => window.show(given), some);
        await show(bubbles);
        await expectCounts(2, 1);
        const box = await page.locator("svg").boundingBox();
        await page.mouse.move(box.x + 155, box.y + 88);
        expect(await red()).toBe(1);
        await show(bubbles.slice(0, 2));
        await expectCounts(3, 2);
        await page.mouse.move(box.x + 105, box.y + 90);
        expect(await red()).toBe(1);
        await page.evaluate(() => window.end());
        await expectCounts(3, 3);
      },
    );
  });

  test("Plot: the mark draws the cells of what the dots are", async () => {
    const path_ = await inPage(
      "plot_mark",
      `import plotMark from "./plot_mark.js";
      plotMark(document.getElementById("container"), ${JSON.stringify(bubbles)});`,
      (page) =>
        page.evaluate(() => ({
          d: document.querySelector('path[stroke="#bbb"]').getAttribute("d"),
          dots: document.querySelectorAll("circle").length,
        })),
    );
    expect(path_.dots).toBe(3);
    expect(path_.d).toMatch(/^M[\d.]+,[\d.]+[CL]/);
  });

  test("Leaflet: every place has its cell, and the one under the pointer is lit", async () => {
    const found = await inPage(
      "leaflet",
      `import "leaflet/dist/leaflet.css";
      import cellsOnMap from "./leaflet.js";
      const places = [
        { lat: 48.86, lon: 2.35, weight: 40 },
        { lat: 45.76, lon: 4.84, weight: 12 },
        { lat: 43.3, lon: 5.37, weight: 15 },
        { lat: 44.84, lon: -0.58, weight: 8 },
      ];
      window.shown = cellsOnMap(document.getElementById("container"), places);`,
      async (page) => {
        const at = await page.evaluate(() => {
          const { x, y } = window.shown.map.latLngToContainerPoint([45.9, 4.9]);
          return { x, y };
        });
        const box = await page.locator("#container").boundingBox();
        await page.mouse.move(box.x + at.x - 3, box.y + at.y);
        await page.mouse.move(box.x + at.x, box.y + at.y);
        const lit = await page.evaluate(() =>
          [...window.shown.polygons]
            .filter(([, polygon]) => polygon.options.fillOpacity === 0.4)
            .map(([id]) => id),
        );
        const size = await page.evaluate(() => {
          const { map, diagram, polygons } = window.shown;
          map.remove();
          let code = null;
          try {
            diagram.size;
          } catch (error) {
            code = error.code;
          }
          return [polygons.size, code];
        });
        return { lit, size };
      },
    );
    expect(found).toEqual({ lit: [1], size: [4, "disposed"] });
  });
});
