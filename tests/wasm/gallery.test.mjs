// Pictures for a person to look at: build/gallery/index.html, written by this test. Each shows the
// circles, the cells (coloured), their edges, centroids (red), the dual graph as Appendix A of the
// paper embeds it (red), and the hull (green).
import { mkdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { Diagram } from "../../build/packed/consumer.mjs";
import { generator } from "./support/random.mjs";

const folder = fileURLToPath(new URL("../../build/gallery/", import.meta.url));
mkdirSync(folder, { recursive: true });

function random(count, seed, radius) {
  const next = generator(seed);
  return Array.from({ length: count }, () => [next() * 100, next() * 100, radius(next())]).flat();
}

function rim(count) {
  const circles = [50, 50, 35];
  for (let k = 0; k < count; ++k) {
    const angle = (2 * Math.PI * k) / count;
    circles.push(50 + 36 * Math.cos(angle), 50 + 36 * Math.sin(angle), 0.5 + (k % 4));
  }
  return circles;
}

const grid = Array.from({ length: 25 }, (_, k) => [
  10 + 20 * (k % 5),
  10 + 20 * Math.floor(k / 5),
  4,
]).flat();

const pictures = {
  "random circles, some hidden": [random(40, 91, (u) => 16 * u ** 3), [-10, -10, 110, 110]],
  "points: the ordinary Voronoi diagram": [random(40, 92, () => 0), [-10, -10, 110, 110]],
  "a window in the middle: centres outside it": [
    random(40, 93, (u) => 12 * u * u),
    [30, 35, 65, 60],
  ],
  "two circles": [
    [30, 50, 20, 75, 50, 8],
    [0, 0, 110, 100],
  ],
  "one circle": [
    [30, 50, 20],
    [0, 0, 110, 100],
  ],
  "a small circle between two large ones: they share two edges": [
    [30, 50, 25, 90, 50, 25, 60, 50, 1],
    [-10, 0, 130, 100],
  ],
  "a giant circle, small ones on its rim": [rim(24), [0, 0, 100, 100]],
  "one cell, two regions": [
    [-60, 50, 58, 50, 50, 0],
    [30, 0, 100, 100],
  ],
  "a window that cuts a hyperbola twice": [
    [0, 0, 3, 10, 0, 1],
    [6.5, -10, 20, 10],
  ],
  "grid: four cells meet in each vertex": [grid, [0, 0, 100, 100]],
  "the same grid, in a window that ends on edges and vertices": [grid, [20, 20, 80, 60]],
  "in line": [
    [0, 0, 5, 20, 0, 5, 40, 0, 5, 55, 0, 2],
    [-15, -25, 70, 25],
  ],
  "radii over three orders of magnitude": [
    random(60, 94, (u) => 0.05 * 1000 ** (u ** 4)),
    [-20, -20, 120, 120],
  ],
  "a circle that just sticks out of another": [
    [50, 50, 30, 79, 50, 1.1, 20, 90, 4],
    [0, 0, 110, 110],
  ],
};

const colors = [
  "#fde0c5",
  "#cfe8f3",
  "#d9f0d3",
  "#f3d9ec",
  "#fff3bf",
  "#dcd6f7",
  "#f8d0d0",
  "#cdeee4",
];

function svg(xyr, bounds) {
  const diagram = new Diagram(xyr);
  const voronoi = diagram.voronoi(bounds);
  const [xmin, ymin, xmax, ymax] = bounds;
  const [width, height] = [xmax - xmin, ymax - ymin];
  const pixel = Math.max(width, height) / 480;
  const parts = [];
  for (const id of diagram.ids()) {
    const cell = voronoi.renderCell(id, null, { digits: 4 });
    if (cell) parts.push(`<path class="cell" d="${cell}" fill="${colors[id % 8]}"/>`);
  }
  parts.push(`<path d="${diagram.renderSites(null, { digits: 4 })}" fill="#0002" stroke="#555"/>`);
  const line = (path, style) => parts.push(`<path d="${path}" fill="none" ${style}/>`);
  line(voronoi.render(null, { digits: 4 }), `stroke="#123" stroke-width="${1.6 * pixel}"`);
  line(diagram.render(null, { bounds, digits: 4 }), `stroke="#c22" stroke-width="${0.8 * pixel}"`);
  line(diagram.renderHull(null, { digits: 4 }), `stroke="#290" stroke-dasharray="${4 * pixel}"`);
  for (const id of diagram.ids()) {
    const centroid = voronoi.cellCentroid(id);
    if (centroid)
      parts.push(`<circle cx="${centroid[0]}" cy="${centroid[1]}" r="${2 * pixel}" fill="#c22"/>`);
  }
  parts.push(`<path d="${voronoi.renderBounds()}" fill="none" stroke="#999"/>`);
  return (
    '<svg xmlns="http://www.w3.org/2000/svg" ' +
    `viewBox="${xmin} ${-ymax} ${width} ${height}" width="480">` +
    `<g transform="scale(1,-1)" stroke-width="${pixel}" stroke-linejoin="round">` +
    `${parts.join("\n")}</g></svg>\n`
  );
}

const files = Object.keys(pictures).map((title) => `${title.replace(/\W+/g, "_")}.svg`);

test.each(
  Object.entries(pictures).map(([title, [xyr, bounds]], k) => [title, xyr, bounds, files[k]]),
)("%s", (_, xyr, bounds, file) => {
  const picture = svg(xyr, bounds);
  writeFileSync(path.join(folder, file), picture);
  expect(picture).not.toMatch(/NaN|Infinity|undefined/);
  const areas = new Diagram(xyr).voronoi(bounds).cellAreas();
  expect(picture.match(/class="cell"/g).length).toBe(areas.filter((area) => area > 0).length);
});

test("the page of all pictures", () => {
  const figures = Object.keys(pictures).map(
    (title, k) => `<figure><img src="${files[k]}"><figcaption>${title}</figcaption></figure>`,
  );
  writeFileSync(
    path.join(folder, "index.html"),
    `<!doctype html><meta charset="utf-8"><title>Gallery</title>
<style>
body { font: 14px sans-serif; display: grid; grid-template-columns: repeat(4, 490px) }
figure { margin: 4px }
</style>
${figures.join("\n")}
`,
  );
});
