// The real data that the page opens on: the largest cities of the world, areas of circles in
// proportion to population. How the files were made: data/make-data.mjs. Unit: kilometres of an
// equal-area map.
import { makeMap } from "./map_layer.js";

const kLargestRadius = 330; // km, of the largest city's circle

async function fetchJson(name) {
  const response = await fetch(new URL(`data/${name}`, import.meta.url));
  if (!response.ok) throw new Error(`${name}: ${response.status} ${response.statusText}`);
  return response.json();
}

const describe = () => {
  const regions = new Intl.DisplayNames(["en"], { type: "region" });
  const numbers = new Intl.NumberFormat("en");
  return (country, population) =>
    `${regions.of(country) ?? country} · ${numbers.format(population)} people`;
};

/**
 * @returns {Promise<{
 *   xyr: Float64Array, labels: import("./scene.js").Label[],
 *   map: import("./map_layer.js").WorldMap, bounds: import("./scene.js").Bounds,
 * }>}
 */
export async function loadCities() {
  const [{ cities }, land] = await Promise.all([fetchJson("cities.json"), fetchJson("land.json")]);
  const detail = describe();
  const perRoot = kLargestRadius / Math.sqrt(cities[0][4]);
  const xyr = new Float64Array(3 * cities.length);
  const labels = cities.map(([name, country, x, y, population], k) => {
    xyr.set([x, y, perRoot * Math.sqrt(population)], 3 * k);
    return { name, detail: detail(country, population) };
  });
  return { xyr, labels, map: makeMap(land), bounds: ringBounds(land.outline) };
}

function ringBounds(ring) {
  /** @type {import("./scene.js").Bounds} */
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  let x = 0;
  let y = 0;
  for (let k = 0; k < ring.length; k += 2) {
    x += ring[k];
    y += ring[k + 1];
    box[0] = Math.min(box[0], x);
    box[1] = Math.min(box[1], y);
    box[2] = Math.max(box[2], x);
    box[3] = Math.max(box[3], y);
  }
  return box;
}
