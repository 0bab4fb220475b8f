// The circles and cells as files.
import { csvFormatRows } from "d3-dsv";

/** @typedef {import("../app.js").App} App */

const kDigits = 2; // of an SVG's pixels

/** x, y, r and the name of each. @param {App} app */
function rowsOf({ sites }) {
  return Array.from(sites.ids, (id) => {
    const { x, y, r } = sites.site(id);
    return { x, y, r, name: sites.labels.get(id)?.name };
  });
}

/** What the window shows, in units. @param {App} app */
const windowOf = ({ view }) =>
  /** @type {const} */ ([
    view.toWorldX(0),
    view.toWorldY(view.height),
    view.toWorldX(view.width),
    view.toWorldY(0),
  ]);

/** The cells as far as they are shown. @param {App} app */
const cellsOf = (app) => app.painter.ends ?? app.diagram.voronoi(windowOf(app));

const rounded = (value) => Number(value.toFixed(kDigits));

/** What the window shows, in pixels. @param {App} app */
export function toSvg(app) {
  const { sites, view, painter, diagram } = app;
  const { theme, layers } = painter;
  const scale = `matrix(${view.scale} 0 0 ${-view.scale} ${view.originX} ${view.originY})`;
  const digits = Math.max(0, Math.min(100, Math.ceil(Math.log10(view.scale)) + kDigits));
  const lines = (name, d, stroke) =>
    `<path class="${name}" transform="${scale}" d="${d}" fill="none" stroke="${stroke}" ` +
    `vector-effect="non-scaling-stroke"/>`;
  const [visible, hidden] = [[], []];
  for (const id of sites.ids) {
    const [x, y] = [view.toScreenX(sites.xyr[3 * id]), view.toScreenY(sites.xyr[3 * id + 1])];
    const r = Math.max(sites.radius(id) * view.scale, 0.5);
    if (x + r < 0 || x - r > view.width || y + r < 0 || y - r > view.height) continue;
    const circle = `<circle cx="${rounded(x)}" cy="${rounded(y)}" r="${rounded(r)}"/>`;
    (sites.isHidden(id) ? hidden : visible).push(circle);
  }
  const group = (name, circles, fill, stroke) =>
    `<g class="${name}" fill="${fill}" stroke="${stroke}">${circles.join("")}</g>`;
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${view.width} ${view.height}">`,
    `<rect width="100%" height="100%" fill="${theme.paper}"/>`,
    layers.dual ? lines("dual", diagram.render(null, { digits }), theme.dual) : "",
    layers.cells ? lines("cells", cellsOf(app).render(null, { digits }), theme.cell) : "",
    layers.circles ? group("circles", visible, theme.siteFill, theme.site) : "",
    layers.hidden ? group("hidden", hidden, theme.hiddenFill, theme.hidden) : "",
    "</svg>",
  ].join("\n");
}

/** @param {App} app */
export const toJson = (app) =>
  `[\n${rowsOf(app)
    .map((row) => JSON.stringify(row))
    .join(",\n")}\n]`;

/** @param {App} app */
export const toCsv = (app) =>
  csvFormatRows([
    ["x", "y", "r", "name"],
    ...rowsOf(app).map(({ x, y, r, name }) => [String(x), String(y), String(r), name ?? ""]),
  ]);

/** The cells as far as they are shown. @param {App} app */
export const toGeoJson = (app) =>
  JSON.stringify(cellsOf(app).toGeoJSON({ tolerance: 0.25 / app.view.scale }));

/** @type {Record<string, { type: string, make: (app: App) => Promise<Blob> | Blob }>} */
const kFormats = {
  png: {
    type: "image/png",
    make: (app) => new Promise((resolve) => app.painter.toCanvas().toBlob(resolve)),
  },
  svg: { type: "image/svg+xml", make: (app) => new Blob([toSvg(app)]) },
  geojson: { type: "application/geo+json", make: (app) => new Blob([toGeoJson(app)]) },
  json: { type: "application/json", make: (app) => new Blob([toJson(app)]) },
  csv: { type: "text/csv", make: (app) => new Blob([toCsv(app)]) },
  bin: {
    type: "application/octet-stream",
    make: (app) => new Blob([/** @type {BlobPart} */ (app.diagram.toBytes())]),
  },
};

/** Saves a file. @param {App} app @param {string} format */
export async function save(app, format) {
  const { type, make } = kFormats[format];
  const blob = new Blob([await make(app)], { type });
  const address = URL.createObjectURL(blob);
  const link = Object.assign(document.createElement("a"), {
    href: address,
    download: `apollonius-diagram.${format}`,
  });
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
