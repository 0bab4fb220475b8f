// Circles from text or a file: a table, JSON or GeoJSON. Which of them it is, its first characters
// say, not its name.
import { type Label, Sites } from "../model/sites.js";
import { type Circles, circlesIn, type Row } from "./columns.js";
import { tableOfCsv } from "./csv.js";
import { putOnEarth } from "./earth.js";
import { onEarthInGeoJson } from "./geojson.js";
import { tableOfJson } from "./json.js";

const kNothing = new Float64Array(0);

/** @param note said of the text, before what is said of its circles */
export async function sitesFromText(text: string, title = "Your data", note = "") {
  const plain = text.replace(/^\uFEFF/, "");
  if (plain.trim() === "") throw new Error("there is no text");
  const sitesIn = ({ rows, about = "" }: Circles) =>
    sitesFromRows({ rows, about: `${note} ${about}`.trim() || undefined }, title);
  if (!/^\s*[[{]/.test(plain)) return sitesIn(circlesIn(tableOfCsv(plain)));
  const data = JSON.parse(plain);
  return putOnEarth(sitesIn(circlesIn(tableOfJson(data))), onEarthInGeoJson(data));
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

export async function sitesFromFile(file: File) {
  const { text, note } = textOf(await file.arrayBuffer());
  return sitesFromText(text, file.name, note);
}

/** Decodes UTF-16 by its first two bytes, UTF-8 where that is valid, else Excel's Windows-1252. */
function textOf(bytes: ArrayBuffer): { text: string; note?: string } {
  const [first, second] = new Uint8Array(bytes, 0, Math.min(2, bytes.byteLength));
  if (first === 0xff && second === 0xfe) return { text: new TextDecoder("utf-16le").decode(bytes) };
  if (first === 0xfe && second === 0xff) return { text: new TextDecoder("utf-16be").decode(bytes) };
  try {
    return { text: new TextDecoder("utf-8", { fatal: true }).decode(bytes) };
  } catch {
    return {
      text: new TextDecoder("windows-1252").decode(bytes),
      note: "The file is not UTF-8 and was read as Windows-1252 (Latin-1).",
    };
  }
}
