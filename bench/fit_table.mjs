// The table of prescribed areas: time, and the accuracy that is reached.
import { short, table, thousands } from "./tables.mjs";

const kSets = {
  fitAreas: "0.5 to 1.5",
  fitTailed: "lognormal, σ 1.5",
  fitInHoles: "0.5 to 1.5, in a shape with three holes",
  fitTailedInHoles: "lognormal, σ 1.5, in a shape with three holes",
};

const seconds = ({ us, items }) => short((us * items) / 1e6);

export function fitTable(records) {
  const rows = records.map((record) => [
    `${thousands(record.n)}, ${kSets[record.op]}`,
    record.contender === "wasm" ? "`fitAreas`" : record.contender,
    record.us === undefined ? record.error : `${seconds(record)}${record.isCutOff ? "*" : ""}`,
    record.deviation === undefined ? "" : record.deviation.toExponential(1),
    record.steps ?? "",
  ]);
  const note =
    "The largest deviation of an area from its share, relative to that, measured by this " +
    "benchmark at the end. d3-voronoi-map has straight edges and also moves the sites (which " +
    "makes cells rounder); `fitAreas` leaves them where they are.";
  return `${note}\n\n${table(["sites, shares", "by", "s", "deviation", "steps"], rows)}`;
}
