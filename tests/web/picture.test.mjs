// The picture, against the diagram: cells hold exactly the points nearest to their site, at any
// zoom; and a picture that was updated box by box equals one that was drawn anew.
import { afterAll, beforeAll, expect, test } from "@jest/globals";
import { describeInBrowser, show, showCircles } from "./support/browser.mjs";
import { generator } from "../../build/web/shared/random_sets.js";

const random = generator(11);
const kSets = {
  one: [0, 0, 5],
  "two equal": [0, 0, 5, 20, 0, 5],
  "two unequal": [0, 0, 5, 20, 0, 1],
  "two overlapping": [0, 0, 15, 5, 3, 11],
  "nearly covered, all around": [0, 0, 10, 9.02, 0, 1, -9.002, 0, 1, 0, 9.0002, 1, 30, 3, 2],
  "collinear, unequal": [0, 0, 1, 10, 0, 3, 20, 0, 2, 40, 0, 2.5],
  "collinear, equal": [0, 0, 1, 10, 0, 1, 20, 0, 1],
  lattice: [0, 0, 1, 10, 0, 1, 0, 10, 1, 10, 10, 1, 20, 0, 1, 20, 10, 1],
  cocircular: [10, 0, 1, 0, 10, 1, -10, 0, 1, 0, -10, 1, 6, 8, 1, -8, 6, 1],
  duplicates: [0, 0, 1, 0, 0, 1, 5, 5, 0, 5, 5, 1, 9, 1, 0],
  giant: [0, 0, 1000, 1001, 0, 1, 0, 1001, 1, -1001, 0, 1, 0, -1001, 1, 750, 750, 3],
  points: Array.from({ length: 30 }, (_, k) => (k % 3 === 2 ? 0 : 100 * random())),
};
for (let k = 0; k < 12; k++) {
  const count = 3 + Math.floor(random() * 15);
  kSets[`random ${k}`] = Array.from({ length: 3 * count }, (_, n) =>
    n % 3 === 2 ? 25 * random() ** 3 : 100 * random(),
  );
}

describeInBrowser("the picture", (open) => {
  let page;
  beforeAll(async () => {
    page = await open();
  });
  afterAll(async () => {
    expect(page.errors).toEqual([]);
    await page.context().close();
  });

  test.each(Object.entries(kSets))("cells: %s", async (_, xyr) => {
    await showCircles(page, xyr);
    const { points, wrong } = await page.evaluate(() => {
      const { addCell } = app.parts;
      const context = document.createElement("canvas").getContext("2d");
      const holds = (id, x, y) => {
        context.beginPath();
        addCell(context, app.sites, app.view, id);
        return context.isPointInPath(x, y);
      };
      const ids = [...app.diagram.ids()];
      const wrong = [];
      let points = 0;
      let seed = 7; // fixed, so that chance does not decide how many are far from a boundary
      const random = () => {
        seed = (seed * 48271) % 2147483647;
        return seed / 2147483647;
      };
      for (const zoom of [1, 0.1, 0.001, 5, 40, 1000]) {
        app.camera.fit();
        app.camera.zoom(zoom, app.view.width * random(), app.view.height * random());
        for (let k = 0; k < 60; k++) {
          const x = app.view.width * random();
          const y = app.view.height * random();
          const far = (id) => {
            const site = app.sites.site(id);
            return (
              Math.hypot(app.view.toWorldX(x) - site.x, app.view.toWorldY(y) - site.y) - site.r
            );
          };
          const [first, second] = ids.sort((a, b) => far(a) - far(b));
          // too near to a boundary
          if (second !== undefined && (far(second) - far(first)) * app.view.scale < 1) continue;
          points++;
          const found = ids.filter((id) => holds(id, x, y));
          if (found.length !== 1 || found[0] !== first) wrong.push({ zoom, x, y, first, found });
        }
      }
      return { points, wrong: wrong.slice(0, 5) };
    });
    expect(wrong).toEqual([]);
    expect(points).toBeGreaterThan(50);
  });

  test.each([
    ["cells", {}],
    ["cells and dual graph", { dual: true }],
    ["cells of many circles, found one by one", { isMany: true }],
  ])("boxes: after many changes the picture is as drawn anew: %s", async (_, { dual, isMany }) => {
    await show(page, "random", { n: isMany ? "2500" : "1000" });
    const { changed, differing, boxes } = await page.evaluate((dual) => {
      app.setLayer("dual", dual);
      app.setLayer("distances", false);
      const canvas = () => app.painter.canvas("lines");
      const pixels = () =>
        canvas().getContext("2d").getImageData(0, 0, canvas().width, canvas().height).data;
      // A line may be drawn half a pixel aside, as curves are approximated box by box.
      const around = (pixels, k) => {
        const row = 4 * canvas().width;
        const places = [-row, 0, row].flatMap((shift) => [k + shift - 4, k + shift, k + shift + 4]);
        return Math.max(...places.map((place) => pixels[place] ?? 0));
      };
      const count = (a, b) => {
        let differing = 0;
        for (let k = 3; k < a.length; k += 4)
          if (Math.abs(a[k] - b[k]) > 110)
            if (a[k] - around(b, k) > 110 || b[k] - around(a, k) > 110) differing++;
        return differing;
      };
      app.painter.flush();
      const start = pixels();
      app.painter.costs.box.length = 0;
      for (let k = 0; k < 60; k++) {
        const ids = app.diagram.ids();
        const id = ids[(k * 37) % ids.length];
        const { x, y, r } = app.sites.site(id);
        if (k % 4 === 0) app.model.update([id], Float64Array.of(x + 30, y - 20, r));
        else if (k % 4 === 1) app.model.update([id], Float64Array.of(x, y, 2.5 * r + 5));
        else if (k % 4 === 2) app.model.remove([id]);
        else app.edits.insertAt(400 + ((k * 53) % 800), 100 + ((k * 31) % 600));
        app.painter.flush();
      }
      const after = pixels();
      app.painter.redraw();
      app.painter.flush();
      return {
        changed: count(start, after),
        differing: count(after, pixels()),
        boxes: app.painter.costs.box.length,
      };
    }, dual ?? false);
    expect(changed).toBeGreaterThan(1000);
    expect(boxes).toBeGreaterThan(40);
    expect(differing).toBeLessThan(20); // anti-aliasing where paths were cut differently
    expect(await page.evaluate(() => app.parts.validate(app.diagram))).toBeNull();
  });

  test("edges found from cell to cell are all edges", async () => {
    await show(page, "random", { n: "3000", hidden: "20" });
    const { found, all } = await page.evaluate(() => {
      const { drawEdges } = app.parts;
      const [xmin, ymin, xmax, ymax] = app.sites.bounds();
      const bounds = [xmin, ymin, (2 * xmin + xmax) / 3, (ymin + ymax) / 2];
      const edges = [];
      const note = (x, y) => edges.push(`${x.toPrecision(9)} ${y.toPrecision(9)}`);
      const target = { moveTo: note, lineTo() {}, bezierCurveTo() {} };
      for (const _ of drawEdges(app.diagram, bounds, target));
      const { curves } = app.diagram.voronoi(bounds).edgeCurves();
      return { found: edges.length, all: curves.length / 7 };
    });
    expect(all).toBeGreaterThan(500);
    expect(found).toBe(all);
  });

  test("many circles, point by point, look like the same circles as paths", async () => {
    await show(page, "random", { n: "1400", hidden: "0" });
    const { covered, differing } = await page.evaluate(() => {
      const { CirclesLayer } = app.parts;
      const { Shower } = app.parts;
      const { width, height } = app.view;
      const picture = {
        sites: app.sites,
        view: app.view,
        layers: app.painter.layers,
        theme: app.painter.theme,
        pixelRatio: 1,
      };
      const canvas = () => new OffscreenCanvas(width, height).getContext("2d");
      const paths = canvas();
      const box = { left: 0, top: 0, right: width, bottom: height };
      new CirclesLayer().draw(paths, picture, box, true);
      const points = canvas();
      const shower = new Shower(width, height);
      const xyr = Float32Array.from(
        Array.from(app.sites.ids).flatMap((id) => {
          const { x, y, r } = app.sites.site(id);
          return [app.view.toScreenX(x), app.view.toScreenY(y), r * app.view.scale];
        }),
      );
      const { siteFill, site } = app.painter.theme;
      shower.add(xyr, xyr.length, { fill: siteFill, stroke: site }, 1);
      shower.show(points);
      const [a, b] = [paths, points].map(
        (context) => context.getImageData(0, 0, width, height).data,
      );
      let covered = 0;
      let differing = 0;
      for (let k = 3; k < a.length; k += 4) {
        if (a[k] > 0) covered++;
        if (Math.abs(a[k] - b[k]) > 90) differing++;
      }
      return { covered, differing };
    });
    expect(covered).toBeGreaterThan(50_000);
    expect(differing / covered).toBeLessThan(0.08);
  });
});
