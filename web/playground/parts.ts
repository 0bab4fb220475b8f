// Parts of the page for its tests, which try them by themselves: those that run, not copies.
import { validate } from "apollonius-diagram/diagnostics";
import { Sites } from "./model/sites.js";
import { CirclesLayer } from "./picture/circles_layer.js";
import { addCell } from "./picture/curves.js";
import { addDisc, addRim } from "./picture/discs.js";
import { drawEdges } from "./picture/edges.js";
import { Shower } from "./picture/shower.js";
import { save } from "./sets/export.js";
import { toGeoJson } from "./sets/geojson.js";
import { sitesFromText } from "./sets/import.js";
import { equalEarth } from "./model/globe.js";
import { toSvg } from "./sets/svg.js";
import { kTools } from "./tools/registry.js";
import { element, kElementIds } from "./ui/elements.js";

export const parts = {
  validate,
  Sites,
  CirclesLayer,
  addCell,
  addDisc,
  addRim,
  drawEdges,
  Shower,
  save,
  toGeoJson,
  toSvg,
  equalEarth,
  sitesFromText,
  element,
  kElementIds,
  kTools,
};
