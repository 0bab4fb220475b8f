// The circles and cells as files.
import { csvFormatRows } from "d3-dsv";
import type { App } from "../app.js";

const kDigits = 2; // of an SVG's pixels

/** x, y, r and the name of each. */
function rowsOf({ sites }: App) {
  return Array.from(sites.ids, (id) => {
    const { x, y, r } = sites.site(id);
    return { x, y, r, name: sites.labels.get(id)?.name };
  });
}

/** What the window shows, in units. */
const windowOf = ({ view }: App) =>
  [
    view.toWorldX(0),
    view.toWorldY(view.height),
    view.toWorldX(view.width),
    view.toWorldY(0),
  ] as const;

/** The cells as far as they are shown. */
const cellsOf = (app: App) => app.painter.ends ?? app.diagram.voronoi(windowOf(app));

const rounded = (value: number) => Number(value.toFixed(kDigits));

/** What the window shows, in pixels. */
export function toSvg(app: App) {
  const { sites, view, painter, diagram } = app;
  const { theme, layers } = painter;
  const scale = `matrix(${view.scale} 0 0 ${-view.scale} ${view.originX} ${view.originY})`;
  const digits = Math.max(0, Math.min(100, Math.ceil(Math.log10(view.scale)) + kDigits));
  const lines = (name: string, d: string, stroke: string) =>
    `<path class="${name}" transform="${scale}" d="${d}" fill="none" stroke="${stroke}" ` +
    `vector-effect="non-scaling-stroke"/>`;
  const visible: string[] = [];
  const hidden: string[] = [];
  for (const id of sites.ids) {
    const [x, y] = [view.toScreenX(sites.xyr[3 * id]), view.toScreenY(sites.xyr[3 * id + 1])];
    const r = Math.max(sites.radius(id) * view.scale, 0.5);
    if (x + r < 0 || x - r > view.width || y + r < 0 || y - r > view.height) continue;
    const circle = `<circle cx="${rounded(x)}" cy="${rounded(y)}" r="${rounded(r)}"/>`;
    (sites.isHidden(id) ? hidden : visible).push(circle);
  }
  const group = (name: string, circles: string[], fill: string, stroke: string) =>
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

export const toJson = (app: App) =>
  `[\n${rowsOf(app)
    .map((row) => JSON.stringify(row))
    .join(",\n")}\n]`;

export const toCsv = (app: App) =>
  csvFormatRows([
    ["x", "y", "r", "name"],
    ...rowsOf(app).map(({ x, y, r, name }) => [String(x), String(y), String(r), name ?? ""]),
  ]);

/** The cells as far as they are shown. */
export const toGeoJson = (app: App) =>
  JSON.stringify(cellsOf(app).toGeoJSON({ tolerance: 0.25 / app.view.scale }));

export type Format = "png" | "svg" | "geojson" | "json" | "csv" | "bin";

const kFormats: Record<Format, { type: string; make: (app: App) => Promise<Blob> | Blob }> = {
  png: {
    type: "image/png",
    make: (app) =>
      new Promise<Blob>((resolve, reject) =>
        app.painter
          .toCanvas()
          .toBlob((blob) => (blob ? resolve(blob) : reject(new Error("it is too large")))),
      ),
  },
  svg: { type: "image/svg+xml", make: (app) => new Blob([toSvg(app)]) },
  geojson: { type: "application/geo+json", make: (app) => new Blob([toGeoJson(app)]) },
  json: { type: "application/json", make: (app) => new Blob([toJson(app)]) },
  csv: { type: "text/csv", make: (app) => new Blob([toCsv(app)]) },
  bin: {
    type: "application/octet-stream",
    make: (app) => new Blob([app.diagram.toBytes()]),
  },
};

export const isFormat = (name: string): name is Format => Object.hasOwn(kFormats, name);

/** Saves a file. */
export async function save(app: App, format: Format) {
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
