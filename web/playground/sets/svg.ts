// The picture as SVG: all that the canvases show but what follows the pointer, drawn by the layers
// themselves, each into a group of its own.
import { escaped } from "../../shared/svg.js";
import type { App } from "../app.js";
import { CirclesLayer } from "../picture/circles_layer.js";
import { windowOf } from "../picture/curves.js";
import { drawLines } from "../picture/lines_layer.js";
import type { Part, WorldMap } from "../model/world_map.js";
import type { Layers, Picture } from "../picture/picture.js";
import { rounded, SvgContext } from "./svg_context.js";

/** The groups of lines, as they lie one above the other. */
const kLines = ["distances", "centres", "dual", "cells", "vertices", "levels", "hull"] as const;
const kCredit = "Cities: GeoNames, CC BY. Land: Natural Earth. Equal Earth projection.";

/** Writes what the window shows, in pixels. */
export function toSvg(app: App) {
  const { sites, view, painter } = app;
  const { theme, layers, ends } = painter;
  const picture: Picture = { sites, view, layers, theme, ends, pixelRatio: 1, isLive: false };
  const { width, height } = view;
  const { map } = sites.info;
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" ` +
      `viewBox="0 0 ${width} ${height}">`,
    `<title>${escaped(sites.info.title)}</title>`,
    ...(sites.info.credit === "cities" ? [`<desc>${kCredit}</desc>`] : []),
    `<rect width="100%" height="100%" fill="${theme.paper}"/>`,
    ...(map && layers.map ? [mapOf(picture, map)] : []),
    ...kLines.filter((name) => layers[name]).map((name) => linesOf(picture, name, app)),
    ...circlesOf(picture),
    "</svg>",
  ].join("\n");
}

const group = (name: string, look: string, inside: string) =>
  `<g class="${name}"${look && ` ${look}`}>${inside}</g>`;

function mapOf({ view, theme }: Picture, { outline, land }: WorldMap) {
  const path = ({ rings }: Part, fill: string) => {
    const d = rings.map((ring) => `M${onScreen(view, ring)}Z`).join("");
    return `<path d="${d}" fill="${fill}"/>`;
  };
  return group("map", `stroke="${theme.coast}"`, path(outline, theme.sea) + path(land, theme.land));
}

/** A ring x, y, … as the points of a path. */
const onScreen = (view: Picture["view"], ring: readonly number[]) =>
  ring.map((v, k) => rounded(k % 2 === 0 ? view.toScreenX(v) : view.toScreenY(v))).join();

/** Returns what the layer of this name draws when it is the only one. */
function linesOf(picture: Picture, name: (typeof kLines)[number], { view, painter }: App) {
  const off = Object.fromEntries(kLines.map((other) => [other, other === name]));
  const layers: Layers = { ...picture.layers, ...off };
  const context = new SvgContext();
  const size = painter.cellSize;
  const expected = (view.width * view.height) / size ** 2;
  const only = { ...picture, layers };
  for (const _ of drawLines(context.asCanvas(), only, windowOf(view), size, expected));
  return group(name, "", context.take());
}

function circlesOf(picture: Picture) {
  const context = new SvgContext();
  const parts = new CirclesLayer().drawParts(context.asCanvas(), picture, windowOf(picture.view));
  return Array.from(parts, (name) => group(name, "", context.take()));
}
