// The recipes of web/examples for frameworks, charts and maps: their types, and, bundled with the
// real libraries as their users would, what they do in the browser; those that a server renders, in
// Node, too.
import { mkdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { beforeAll, expect, test } from "@jest/globals";
import { root } from "../../tools/toolchain/folders.mjs";
import { run } from "../../tools/toolchain/process.mjs";
import { closePage, describeInBrowser, describeWithWebGL } from "../web/support/browser.mjs";
import {
  bundledForPage,
  bundledModule,
  copyRecipes,
  printedByServer,
  recipes,
} from "./support/recipes.mjs";

beforeAll(copyRecipes);

test("their types", () => {
  const config = { extends: "../../web/examples/tsconfig.json", exclude: [] };
  const file = path.join(recipes, "tsconfig.json");
  writeFileSync(file, JSON.stringify({ ...config, include: ["*.js", "*.d.ts"] }));
  run(process.execPath, [path.join(root, "node_modules/typescript/bin/tsc"), "-p", file]);
});

const pictures = path.join(root, "build/pictures");
const bubbles = [
  { x: 100, y: 80, r: 50 },
  { x: 190, y: 90, r: 15 },
  { x: 105, y: 90, r: 10 },
];
const given = `const bubbles = ${JSON.stringify(bubbles)};`;
/** Charts are given x, y, radius in pixels, name. */
const rows = [
  [10, 20, 50, "large"],
  [12, 21, 15, "small"],
  [10.2, 20, 10, "inner"],
  [30, 45, 25, "other"],
];

/** A file that the server shows as text: a document without a policy of its own, quick to open. */
const kBare = "examples/examples.css";

/** A page for a program, with a container of some HTML; keeps a picture for people to look at. */
const withPages = (open) =>
  async function inPage(name, program, act, { html = "", file, end } = {}) {
    const page = await open({ path: kBare, ready: null });
    page.on("console", (said) => said.type() === "warning" && page.errors.push(said.text()));
    const style = "width: 700px; height: 420px";
    await page.setContent(`<div id="container" style="${style}">${html}</div>`);
    await page.addScriptTag({ content: await bundledForPage(program, file) });
    const found = await act(page, await page.locator("#container").boundingBox());
    mkdirSync(pictures, { recursive: true });
    await page.screenshot({ path: path.join(pictures, `recipe_${name}.png`) });
    if (end) await page.evaluate(end);
    expect(page.errors).toEqual([]);
    await closePage(page);
    return found;
  };

/** Where a bubble is, once its chart has become narrower. */
async function narrowed(page, id) {
  const before = await page.evaluate((k) => window.where()[k], id);
  await page.evaluate(() =>
    Object.assign(document.getElementById("container").style, { width: "420px" }),
  );
  const isElsewhere = ([k, x]) => window.where()[k][0] < x - 50;
  await page.waitForFunction(isElsewhere, [id, before[0]]);
  return page.evaluate((k) => window.where()[k], id);
}

/** The colour of a point on the screen, which no canvas tells of WebGL. */
async function colourAt(page, x, y) {
  const png = await page.screenshot({ clip: { x, y, width: 1, height: 1 } });
  return page.evaluate(
    async (data) => {
      const bitmap = await createImageBitmap(await (await fetch(data)).blob());
      const context = new OffscreenCanvas(1, 1).getContext("2d");
      context.drawImage(bitmap, 0, 0);
      return [...context.getImageData(0, 0, 1, 1).data.slice(0, 3)];
    },
    `data:image/png;base64,${png.toString("base64")}`,
  );
}

/**
 * Programs of each framework, for what a server renders and a page takes over: `server` prints the
 * HTML, and `browser` has `show(bubbles)` and `end()`.
 */
const kFrameworks = {
  react: {
    file: "react.jsx",
    server: `
      import { StrictMode } from "react";
      import { renderToString } from "react-dom/server";
      import BubbleChart from "./react.jsx";
      const chart = <StrictMode><BubbleChart bubbles={bubbles} /></StrictMode>;
      process.stdout.write(renderToString(chart));`,
    browser: `
      import { StrictMode } from "react";
      import { flushSync } from "react-dom";
      import { hydrateRoot } from "react-dom/client";
      import BubbleChart from "./react.jsx";
      const chart = (bubbles) => <StrictMode><BubbleChart bubbles={bubbles} /></StrictMode>;
      const root = hydrateRoot(document.getElementById("container"), chart(bubbles), {
        onRecoverableError: (error) => console.error(String(error)),
      });
      window.show = (bubbles) => flushSync(() => root.render(chart(bubbles)));
      window.end = () => root.unmount();`,
  },
  vue: {
    file: "vue.js",
    server: `
      import { createSSRApp, h } from "vue";
      import { renderToString } from "vue/server-renderer";
      import BubbleChart from "./bubble_chart.vue";
      const app = createSSRApp({ render: () => h(BubbleChart, { bubbles }) });
      renderToString(app).then((html) => process.stdout.write(html));`,
    browser: `
      import { createSSRApp, h, isProxy, nextTick, reactive, ref } from "vue";
      import { Diagram } from "apollonius-diagram";
      import BubbleChart from "./bubble_chart.vue";
      const props = reactive({ bubbles });
      const app = createSSRApp({ render: () => h(BubbleChart, props) });
      app.mount(document.getElementById("container"));
      window.show = (bubbles) => {
        props.bubbles = bubbles;
        return nextTick();
      };
      window.end = () => app.unmount();
      const diagram = Diagram.from(bubbles);
      const cells = ref(diagram.voronoi()).value;
      const held = [ref(diagram).value, reactive({ diagram }).diagram, cells];
      if (held.some(isProxy) || held[0] !== diagram) console.error("a proxy of a diagram");`,
  },
  svelte: {
    file: "app.svelte.js",
    server: `
      import { render } from "svelte/server";
      import BubbleChart from "./bubble_chart.svelte";
      process.stdout.write(render(BubbleChart, { props: { bubbles } }).body);`,
    browser: `
      import { flushSync, hydrate, unmount } from "svelte";
      import BubbleChart from "./bubble_chart.svelte";
      const props = $state({ bubbles });
      const target = document.getElementById("container");
      const chart = hydrate(BubbleChart, { target, props, recover: false });
      window.show = (bubbles) => {
        props.bubbles = bubbles;
        flushSync();
      };
      window.end = () => unmount(chart);`,
  },
};

describeInBrowser("recipes", (open) => {
  const inPage = withPages(open);

  test.each(
    Object.entries(kFrameworks),
  )("%s: what the server rendered is taken over, and picks", async (name, framework) => {
    const { file, server, browser } = framework;
    const html = await printedByServer(given + server, file);
    expect(html).toMatch(/ d="M[\d.]+,[\d.]+[CL]/);
    expect(html.match(/<circle/g).length).toBe(3);
    const act = async (page, { x, y }) => {
      const isRed = (expected) => {
        const circles = [...document.querySelectorAll("circle")];
        const fills = circles.map((circle) => circle.getAttribute("fill") === "#e15759");
        return fills.flatMap((is, id) => (is ? [id] : [])).join() === expected;
      };
      const expectRed = (...ids) => page.waitForFunction(isRed, ids.join());
      const d = () => page.locator("path").getAttribute("d");
      const drawn = await d();
      expect(html).toContain(drawn); // the same bits in Node
      await page.mouse.move(x + 155, y + 88);
      await expectRed(0);
      await page.mouse.move(x + 105, y + 90);
      await expectRed(2);
      // The pointer stays, and who is there is another one.
      await page.evaluate((some) => window.show(some), bubbles.slice(0, 2));
      await expectRed(0);
      expect(await d()).toBe(drawn); // the one that went was hidden
      await page.evaluate((some) => window.show(some), bubbles.slice(1));
      await expectRed(1);
      expect(await d()).not.toBe(drawn);
      await page.mouse.move(x + 400, y + 300);
      await expectRed();
      await page.mouse.move(x + 178, y + 88);
      await expectRed(0);
    };
    await inPage(name, given + browser, act, { html, file, end: () => window.end?.() });
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

  test("ECharts: the nearest bubble is lit, the smallest of several, with its tip", async () => {
    await inPage(
      "echarts",
      `import nearestInChart from "./echarts.js";
      const container = document.getElementById("container");
      window.shown = nearestInChart(container, ${JSON.stringify(rows)});
      window.where = () => ${JSON.stringify(rows)}.map(([x, y]) =>
        window.shown.chart.convertToPixel({ seriesIndex: 0 }, [x, y]));`,
      async (page, box) => {
        const pointAt = ([x, y]) => page.mouse.move(box.x + x, box.y + y);
        const expectPicked = async (id, name) => {
          const isPicked = (id) => window.shown.picked() === id;
          await page.waitForFunction(isPicked, id);
          if (name) await page.locator(`#container div:text-is("${name}")`).waitFor();
        };
        const places = await page.evaluate(() => window.where());
        const [large, , inner, other] = places;
        await pointAt([large[0] - 20, large[1]]);
        await expectPicked(0, "large");
        await pointAt(inner);
        await expectPicked(2, "inner");
        await pointAt([other[0], other[1] + 25 + 10]);
        await expectPicked(3, "other");
        // the canvas is painted with the next frame
        const isRed = ([x, y]) => {
          const context = document.querySelector("#container canvas").getContext("2d");
          const [r, , b] = context.getImageData(x, y, 1, 1).data;
          return r > 200 && b < 150;
        };
        await page.waitForFunction(isRed, other);
        await pointAt([other[0], other[1] + 25 + 30]);
        await expectPicked(-1);
        const moved = await narrowed(page, 3);
        await pointAt([moved[0], moved[1] + 25 + 10]);
        await expectPicked(3, "other");
      },
      { end: () => window.shown.end() },
    );
  });

  test("Vega-Lite: nearest is by circles, within reach, and cells are drawn", async () => {
    const data = rows.map(([x, y, r, name]) => ({ x, y, r, name }));
    await inPage(
      "vega_lite",
      `import { Diagram } from "apollonius-diagram";
      import nearestInChart from "./vega_lite.js";
      const container = document.getElementById("container");
      nearestInChart(container, ${JSON.stringify(data)}).then((shown) => {
        Object.assign(window, { shown });
      });
      const symbols = () => window.shown.view.data("marks");
      window.lit = () =>
        symbols().filter(({ fill }) => fill === "#e15759").map(({ datum }) => datum.name).join();
      const toPage = ([x, y]) => {
        const [left, top] = window.shown.view.origin();
        const padding = window.shown.view.padding();
        return [x + left + padding.left, y + top + padding.top];
      };
      window.where = () => {
        const [x, y] = ["x", "y"].map((name) => window.shown.view.scale(name));
        return ${JSON.stringify(data)}.map((row) => toPage([x(row.x), y(row.y)]));
      };
      // Counts the points of a grid with a wrong answer; not where half a pixel decides.
      window.wrong = () => {
        const items = symbols();
        const circles = items.map(({ x, y, size }) => ({ x, y, r: Math.sqrt(size) / 2 }));
        const diagram = Diagram.from(circles);
        const box = container.getBoundingClientRect();
        const wrong = [];
        for (let x = 2; x < window.shown.view.width(); x += 13)
          for (let y = 2; y < window.shown.view.height(); y += 13) {
            const around = [[-0.5, 0], [0.5, 0], [0, -0.5], [0, 0.5]];
            const ids = around.map(([dx, dy]) => diagram.pick(x + dx, y + dy, { maxDistance: 20 }));
            if (new Set(ids).size > 1) continue;
            const [px, py] = toPage([x, y]);
            const there = document.elementFromPoint(box.x + px, box.y + py).__data__;
            const name = there?.isVoronoi && there.datum.datum.name;
            if ((name || undefined) !== items[ids[0]]?.datum.name) wrong.push([x, y, name]);
          }
        return wrong;
      };`,
      async (page, box) => {
        await page.waitForFunction(() => window.shown);
        const pointAt = ([x, y]) => page.mouse.move(box.x + x, box.y + y);
        const expectLit = async (name) => {
          await page.waitForFunction((name) => window.lit() === name, name);
          if (name) await page.locator(`#vg-tooltip-element.visible:text-is("${name}")`).waitFor();
        };
        const [large, , inner, other] = await page.evaluate(() => window.where());
        await pointAt([large[0] - 45, large[1]]);
        await expectLit("large");
        await pointAt(inner);
        await expectLit("inner");
        await pointAt([other[0], other[1] + 25 + 15]);
        await expectLit("other");
        await pointAt([other[0], other[1] + 25 + 25]);
        await expectLit("");
        expect(await page.evaluate(() => window.wrong())).toEqual([]);
        expect(await page.locator('path[stroke="#bbb"][d]').count()).toBe(3); // inner is hidden
        // Zoomed in, and smaller, bubbles are elsewhere.
        await pointAt(large);
        await page.mouse.wheel(0, -200);
        await page.waitForFunction(([x]) => window.where()[3][0] > x + 50, other);
        await page.evaluate(() => {
          document.getElementById("container").style.width = "420px";
          dispatchEvent(new Event("resize"));
        });
        await page.waitForFunction(([x]) => window.where()[3][0] < x - 50, other);
        await pointAt([box.width + 5, box.height + 5]); // the tip would cover what it is asked for
        await expectLit("");
        await page.locator("#vg-tooltip-element:not(.visible)").waitFor({ state: "attached" });
        expect(await page.evaluate(() => window.wrong())).toEqual([]);
        const [, small] = await page.evaluate(() => window.where());
        await pointAt([small[0] + 15 + 15, small[1] + 5]);
        await expectLit("small");
      },
      { end: () => window.shown.finalize() },
    );
  });

  test("Chart.js: the mode takes rims for centres, and what is under the pointer", async () => {
    await inPage(
      "chartjs",
      `import { Chart, registerables } from "chart.js";
      import circleMode from "./chartjs.js";
      Chart.register(...registerables, circleMode);
      const canvas = document.getElementById("container").appendChild(
        document.createElement("canvas"));
      const large = { label: "large", data: [{ x: 10, y: 20, r: 60 }] };
      const small = { label: "small", data: [{ x: 16, y: 20, r: 5 }, { x: 10.5, y: 21, r: 8 }] };
      window.chart = new Chart(canvas, {
        type: "bubble",
        data: { datasets: [large, small] },
        options: {
          animation: false, // which shows what is going to be hidden for a while
          interaction: { mode: "circle", intersect: false },
          hoverBackgroundColor: "#e15759",
          scales: { x: { min: 0, max: 30 }, y: { min: 0, max: 40 } },
        },
      });
      window.at = (dataset, index) => {
        const { x, y } = window.chart.getDatasetMeta(dataset).data[index];
        return [x, y];
      };
      window.active = () =>
        window.chart.getActiveElements().map((one) => [one.datasetIndex, one.index]).join();`,
      async (page, box) => {
        const pointAt = ([x, y]) => page.mouse.move(box.x + x, box.y + y);
        const at = (...which) => page.evaluate((which) => window.at(...which), which);
        const expectActive = (...which) =>
          page.waitForFunction((which) => window.active() === which, which.join());
        const [large, small, inner] = [await at(0, 0), await at(1, 0), await at(1, 1)];
        // In the large one, while the centre of the small one is nearer.
        expect(small[0] - large[0]).toBeLessThan(2 * 58);
        await pointAt([large[0] + 58, large[1]]);
        await expectActive(0, 0);
        await pointAt(inner);
        await expectActive(1, 1);
        await pointAt([small[0] + 50, small[1]]);
        await expectActive(1, 0);
        // A hidden series does not count; nor does, if so told, a point outside the chart's area.
        await page.evaluate(() => window.chart.hide(1));
        await pointAt([small[0] + 52, small[1]]);
        await expectActive(0, 0);
        await page.evaluate(() => {
          window.chart.options.interaction.intersect = true;
          window.chart.show(1);
        });
        await pointAt([small[0] + 50, small[1]]);
        await expectActive();
        await pointAt(small);
        await expectActive(1, 0);
      },
      { end: () => window.chart.destroy() },
    );
  });
});

describeWithWebGL("recipes with WebGL", (open) => {
  const inPage = withPages(open);
  /** Waits until a point of the screen is red, or is not. */
  async function expectRed(page, x, y, expected) {
    for (let k = 0; ; ++k) {
      const [r, g, b] = await colourAt(page, x, y);
      const isRed = r > g + 40 && r > b + 40;
      if (isRed === expected) return;
      if (k === 100) throw new Error(`${x}, ${y} has the colour ${[r, g, b]}`);
    }
  }

  test("deck.gl: the smallest under the pointer, else the nearest within reach", async () => {
    await inPage(
      "deckgl",
      `${given}
      import nearestInDeck from "./deckgl.js";
      const container = document.getElementById("container");
      window.drawn = 0;
      window.shown = nearestInDeck(container, bubbles);
      window.shown.deck.setProps({ onAfterRender: () => ++window.drawn });`,
      async (page, { x, y }) => {
        await page.waitForFunction(() => window.drawn > 0);
        const pointAt = async (px, py, id) => {
          await page.mouse.move(x + px, y + py);
          const isPicked = (id) => window.shown.picked() === id;
          await page.waitForFunction(isPicked, id);
        };
        await expectRed(page, x + 80, y + 60, false);
        await pointAt(145, 90, 0);
        await expectRed(page, x + 80, y + 60, true);
        await pointAt(105, 90, 2); // that the large one may cover
        await pointAt(190, 122, 1);
        await pointAt(190, 130, -1);
        // Zoomed in, 20 pixels are less.
        await page.evaluate(() =>
          window.shown.deck.setProps({ initialViewState: { target: [190, 90, 0], zoom: 2 } }),
        );
        const isZoomed = () => window.shown.deck.getViewports()[0].zoom === 2;
        await page.waitForFunction(isZoomed);
        await pointAt(350, 210 + 60 + 25, -1);
        await pointAt(350, 210 + 60 + 15, 1);
        await expectRed(page, x + 350, y + 210, true);
      },
      { end: () => window.shown.end() },
    );
  });

  test("Plotly: the nearest rim is lit in WebGL, with its label", async () => {
    await inPage(
      "plotly",
      `import nearestInChart from "./plotly.js";
      const container = document.getElementById("container");
      nearestInChart(container, ${JSON.stringify(rows)}).then((shown) => {
        Object.assign(window, { shown });
        shown.chart.on("plotly_click", ({ points }) => {
          window.clicked = points.map(({ pointNumber }) => pointNumber).join();
        });
      });
      window.where = () => {
        const { xaxis, yaxis } = window.shown.chart._fullLayout;
        return ${JSON.stringify(rows)}.map(([x, y]) =>
          [xaxis.d2p(x) + xaxis._offset, yaxis.d2p(y) + yaxis._offset]);
      };`,
      async (page, box) => {
        await page.waitForFunction(() => window.shown);
        const pointAt = ([x, y]) => page.mouse.move(box.x + x, box.y + y);
        const expectPicked = async (id) => {
          const isPicked = (id) => window.shown.picked() === id;
          await page.waitForFunction(isPicked, id);
          const label = page.locator("#container .hoverlayer .hovertext");
          if (id < 0) await label.waitFor({ state: "detached" });
          else await label.filter({ hasText: rows[id][3] }).waitFor();
        };
        const [large, , inner, other] = await page.evaluate(() => window.where());
        await pointAt([large[0] - 45, large[1]]); // where Plotly finds nothing
        await expectPicked(0);
        await expectRed(page, box.x + large[0] - 30, box.y + large[1], true);
        await pointAt(inner);
        await expectPicked(2);
        await page.mouse.down();
        await page.mouse.up();
        await page.waitForFunction(() => window.clicked === "2");
        await pointAt([other[0], other[1] + 25 + 15]);
        await expectPicked(3);
        await pointAt([other[0], other[1] + 25 + 25]);
        await expectPicked(-1);
        const moved = await narrowed(page, 3);
        await pointAt([moved[0], moved[1] + 25 + 10]);
        await expectPicked(3);
        await page.mouse.move(box.x + 5, box.y + 5);
        await expectPicked(-1);
      },
      { end: () => window.shown.end() },
    );
  });

  test("MapLibre: cells in true kilometres, and the one under the pointer is lit", async () => {
    const worker = await bundledModule("maplibre-gl/dist/maplibre-gl-worker.mjs");
    await inPage(
      "maplibre",
      `import { setWorkerUrl } from "maplibre-gl";
      import cellsOnMap from "./maplibre.js";
      const worker = new Blob([${JSON.stringify(worker)}], { type: "text/javascript" });
      setWorkerUrl(URL.createObjectURL(worker));
      const places = [
        { lon: 2.35, lat: 48.86, reach: 60 },
        { lon: 4.84, lat: 45.76, reach: 20 },
        { lon: 5.37, lat: 43.3, reach: 20 },
        { lon: -0.58, lat: 44.84, reach: 10 },
        { lon: 2.2, lat: 48.8, reach: 0 },
      ];
      cellsOnMap(document.getElementById("container"), places).then((shown) => {
        Object.assign(window, { shown });
      });`,
      async (page, box) => {
        await page.waitForFunction(() => window.shown);
        const at = await page.evaluate(() => {
          const { x, y } = window.shown.map.project([4.9, 45.9]);
          return [x, y];
        });
        const [x, y] = [box.x + at[0], box.y + at[1]];
        const isLoaded = () => window.shown.map.loaded() && window.shown.lit() === -1;
        await page.waitForFunction(isLoaded);
        await expectRed(page, x, y, false);
        await page.mouse.move(x - 3, y);
        await page.mouse.move(x, y);
        await page.waitForFunction(() => window.shown.lit() === 1);
        await expectRed(page, x, y, true);
        const features = await page.evaluate(async () => {
          const { map, diagram } = window.shown;
          const known = map.querySourceFeatures("cells").map(({ id }) => id);
          return [[...new Set(known)].sort(), diagram.hiddenSize];
        });
        expect(features).toEqual([[0, 1, 2, 3], 1]);
      },
      { end: () => window.shown.map.remove() },
    );
  });
});
