// The real data that the page opens on: the largest cities of the world, areas of circles in
// proportion to population. How the files were made: data/make-data.mjs. Unit: kilometres of an
// equal-area map.
import { Sites } from "../model/sites.js";
import { type MapData, makeMap } from "../picture/map_layer.js";
import { Globe } from "./globe.js";

const kLargestRadius = 330; // km, of the largest city's circle

/** Of data/cities.json: name, country, x, y, population. */
type City = [string, string, number, number, number];

/** What our own file holds. */
async function fetchJson<Data>(name: string): Promise<Data> {
  const response = await fetch(`../data/${name}`);
  if (!response.ok) throw new Error(`${name}: ${response.status} ${response.statusText}`);
  return response.json();
}

const describe = () => {
  const regions = new Intl.DisplayNames(["en"], { type: "region" });
  const numbers = new Intl.NumberFormat("en");
  return (country: string, population: number) =>
    `${regions.of(country) ?? country} · ${numbers.format(population)} people`;
};

let files: Promise<[{ cities: City[] }, MapData]> | null = null;

/** Asks for the files, once; again if that failed. */
export function fetchCities() {
  files ??= Promise.all([
    fetchJson<{ cities: City[] }>("cities.json"),
    fetchJson<MapData>("land.json"),
  ]);
  files.catch(() => {
    files = null;
  });
  return files;
}

export async function loadCities(): Promise<Sites> {
  const [{ cities }, land] = await fetchCities();
  const detail = describe();
  const perRoot = kLargestRadius / Math.sqrt(cities[0][4]);
  const xyr = new Float64Array(3 * cities.length);
  const labels = cities.map(([name, country, x, y, population], k) => {
    xyr.set([x, y, perRoot * Math.sqrt(population)], 3 * k);
    return { name, detail: detail(country, population) };
  });
  const info = {
    key: "cities",
    title: "Cities of the world",
    about: "Areas: population. Cells are the flat map’s, kilometres the globe’s.",
    areaUnit: "km²", // a map of equal areas; its distances are not those on the Earth
    map: makeMap(land),
    globe: new Globe(),
    credit: "cities",
  };
  return new Sites(xyr, info, { labels });
}
