// The circles and cells as files.
import { csvFormatRows } from "d3-dsv";
import { make } from "../../shared/dom.js";
import type { App } from "../app.js";
import type { Row } from "./columns.js";
import { toGeoJson } from "./geojson.js";
import { toSvg } from "./svg.js";

/** x, y, r and what each is called. */
const rowsOf = ({ sites }: App): Row[] =>
  Array.from(sites.ids, (id) => ({ ...sites.site(id), ...sites.labels.get(id) }));

export const toJson = (app: App) =>
  `[\n${rowsOf(app)
    .map((row) => JSON.stringify(row))
    .join(",\n")}\n]`;

export function toCsv(app: App) {
  const rows = rowsOf(app);
  const columns = ["x", "y", "r", "name", "detail"] as const;
  const used = columns.slice(0, rows.some(({ detail }) => detail) ? 5 : 4);
  return csvFormatRows([
    used,
    ...rows.map((row) => used.map((column) => String(row[column] ?? ""))),
  ]);
}

export type Format = "png" | "svg" | "geojson" | "json" | "csv";

const kFormats: Record<Format, { type: string; content: (app: App) => Promise<Blob> | string }> = {
  png: {
    type: "image/png",
    content: (app) =>
      new Promise((resolve, reject) =>
        app.painter
          .toCanvas()
          .toBlob((data) => (data ? resolve(data) : reject(new Error("it is too large")))),
      ),
  },
  svg: { type: "image/svg+xml", content: toSvg },
  geojson: { type: "application/geo+json", content: toGeoJson },
  json: { type: "application/json", content: toJson },
  csv: { type: "text/csv", content: toCsv },
};

export const isFormat = (name: string): name is Format => Object.hasOwn(kFormats, name);

/** Saves a file. */
export async function save(app: App, format: Format) {
  const { type, content } = kFormats[format];
  const blob = new Blob([await content(app)], { type });
  const address = URL.createObjectURL(blob);
  make("a", { href: address, download: `apollonius-diagram.${format}` }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
