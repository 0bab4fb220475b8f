// The picture: everything that the painter and its layers draw from.
import type { Voronoi } from "apollonius-diagram";
import type { Sites } from "../model/sites.js";
import type { Theme } from "../../shared/theme.js";
import type { View } from "./view.js";

/** The layers, each shown or not. */
export type Layers = {
  cells: boolean;
  distances: boolean;
  circles: boolean;
  hidden: boolean;
  map: boolean;
  coast: boolean;
  dual: boolean;
  centres: boolean;
  vertices: boolean;
  levels: boolean;
  hull: boolean;
};
/**
 * The layers draw from this; `isLive`: in one go; `ends`: the cells, if they end before the
 * window's border.
 */
export type Picture = {
  sites: Sites;
  view: View;
  layers: Layers;
  theme: Theme;
  pixelRatio: number;
  isLive: boolean;
  ends: Voronoi | null;
};

/** Whether there is a layer of this name: from an address, or from the menu. */
export const isLayer = (layers: Layers, name: string): name is keyof Layers =>
  Object.hasOwn(layers, name);
