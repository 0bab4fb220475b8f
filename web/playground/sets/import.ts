// Circles from text or a file: a table, JSON, GeoJSON, or a snapshot. What a file is, its first
// bytes say, not its name.
import { Diagram } from "apollonius-diagram";
import { type Label, Sites } from "../model/sites.js";
import { type Circles, circlesIn, type Row } from "./columns.js";
import { tableOfCsv } from "./csv.js";
import { putOnEarth } from "./earth.js";
import { onEarthInGeoJson } from "./geojson.js";
import { tableOfJson } from "./json.js";
import { isPacked, isSnapshot, type Named, unpacked } from "./snapshot.js";

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

/** @param bytes from anyone: they are proved */
export function sitesFromSnapshot(bytes: Uint8Array, title = "Snapshot", names: Named[] = []) {
  const diagram = Diagram.fromBytes(bytes);
  const ids = diagram.ids();
  const xyr = new Float64Array(ids.length === 0 ? 0 : 3 * ids[ids.length - 1] + 3);
  for (const id of ids) {
    const { x, y, r } = diagram.site(id);
    xyr.set([x, y, r], 3 * id);
  }
  const sites = new Sites(xyr, { key: "data", title }, { diagram, original: kNothing });
  for (const { id, ...label } of names) if (diagram.has(id)) sites.labels.set(id, label);
  return sites;
}

export async function sitesFromFile(file: File) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (isSnapshot(bytes)) return sitesFromSnapshot(bytes, file.name);
  if (isPacked(bytes)) {
    const { snapshot, names, onEarth } = unpacked(bytes);
    return putOnEarth(sitesFromSnapshot(snapshot, file.name, names), onEarth);
  }
  return sitesFromText(new TextDecoder().decode(bytes), file.name);
}
