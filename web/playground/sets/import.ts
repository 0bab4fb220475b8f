// Circles from text or a file: a table, JSON or GeoJSON. Which of them it is, its first characters
// say, not its name.
import { type Label, Sites } from "../model/sites.js";
import { type Circles, circlesIn, type Row } from "./columns.js";
import { tableOfCsv } from "./csv.js";
import { putOnEarth } from "./earth.js";
import { onEarthInGeoJson } from "./geojson.js";
import { tableOfJson } from "./json.js";

const kNothing = new Float64Array(0);

export async function sitesFromText(text: string, title: string = "Your data") {
  const plain = text.replace(/^\uFEFF/, "");
  if (plain.trim() === "") throw new Error("there is no text");
  if (!/^\s*[[{]/.test(plain)) return sitesFromRows(circlesIn(tableOfCsv(plain)), title);
  const data = JSON.parse(plain);
  const sites = sitesFromRows(circlesIn(tableOfJson(data)), title);
  return putOnEarth(sites, onEarthInGeoJson(data));
}

export function sitesFromRows({ rows, about }: Circles, title: string) {
  const xyr = Float64Array.from(rows.flatMap(({ x, y, r }) => [x, y, r]));
  return new Sites(
    xyr,
    { key: "data", title, about },
    { labels: rows.map(labelOf), original: kNothing },
  );
}

const labelOf = ({ name, detail }: Row): Label | undefined => (name ? { name, detail } : undefined);

export const sitesFromFile = async (file: File) => sitesFromText(await file.text(), file.name);
