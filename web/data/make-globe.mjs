// Makes web/figures/globe_places.ts, the places of a figure, from cities.json and land.json: large
// cities that are far from each other, and coasts with little detail. Only needed to change them:
//   node web/data/make-globe.mjs
import { readFileSync, writeFileSync } from "node:fs";
import { geoDistance, geoEqualEarth } from "d3-geo";

const kEarthRadius = 6371; // km
const kCities = 60;
const kCityGap = 900; // km between two of them
const kCoastGap = 170; // km between two points of a coast
const kLeastLand = 40_000; // square km
const kColumns = 96; // of a line of text

const read = (name) => JSON.parse(readFileSync(new URL(name, import.meta.url), "utf8"));
const map = geoEqualEarth().scale(kEarthRadius).translate([0, 0]);
const lonLat = (x, y) => map.invert([x, -y]);
const rounded = (place, digits) => place.map((degrees) => Number(degrees.toFixed(digits)));

/** The largest that have no larger one near. */
function cities() {
  const chosen = [];
  for (const [name, , x, y, people] of read("cities.json").cities) {
    const place = lonLat(x, y);
    const isNear = (other) => geoDistance(place, other.place) * kEarthRadius < kCityGap;
    if (chosen.length < kCities && !chosen.some(isNear)) chosen.push({ name, place, people });
  }
  return chosen;
}

/** The rings of land, x, y and then steps, without points that are near the last one. */
function coasts() {
  const rings = [];
  for (const steps of read("land.json").land) {
    const ring = [];
    let [x, y, lastX, lastY, area] = [0, 0, Infinity, Infinity, 0];
    for (let k = 0; k < steps.length; k += 2) {
      const [px, py] = [x, y];
      x += steps[k];
      y += steps[k + 1];
      area += (px * y - x * py) / 2;
      if (Math.hypot(x - lastX, y - lastY) < kCoastGap) continue;
      [lastX, lastY] = [x, y];
      ring.push(rounded(lonLat(x, y), 1).join());
    }
    if (Math.abs(area) > kLeastLand && ring.length > 3) rings.push([...ring, ring[0]].join(" "));
  }
  return rings;
}

/** A long text as lines of a string that are put together. */
function quoted(text) {
  const lines = text.match(new RegExp(`.{1,${kColumns - 8}}(?: |$)`, "g"));
  return lines.map((line) => JSON.stringify(line)).join(" +\n    ");
}

const cityLines = cities().map(
  ({ name, place, people }) => `  ${JSON.stringify([name, ...rounded(place, 2), people])},`,
);
writeFileSync(
  new URL("../figures/globe_places.ts", import.meta.url),
  `// Made by web/data/make-globe.mjs. Cities: GeoNames (CC BY 4.0); coasts: Natural Earth.

/** Name, longitude, latitude, people; the largest first. */
export const kCities: readonly (readonly [string, number, number, number])[] = [
${cityLines.join("\n")}
];

/** Rings of the land as "longitude,latitude longitude,latitude …". */
export const kCoasts: readonly string[] = [
${coasts()
  .map((ring) => `  ${quoted(ring)},`)
  .join("\n")}
];
`,
);
