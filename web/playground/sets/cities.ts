// The real data that the page opens on: the largest cities of the world, areas of circles in
// proportion to population. How the files were made: data/make-data.mjs. Unit: kilometres of an
// equal-area map.
import { type SetInfo, Sites } from "../model/sites.js";
import { fetchData } from "./data_files.js";
import { earthInfo, fetchMap } from "./earth.js";

const kLargestRadius = 330; // km, of the largest city's circle

/** A row of data/cities.json: name, country, x, y, population. */
type City = [string, string, number, number, number];

const describe = () => {
  const regions = new Intl.DisplayNames(["en"], { type: "region" });
  const numbers = new Intl.NumberFormat("en");
  return (country: string, population: number) =>
    `${regions.of(country) ?? country} · ${numbers.format(population)} people`;
};

/** Asks for what they are made from. */
export const fetchCities = () =>
  Promise.all([fetchData<{ cities: City[] }>("cities.json"), fetchMap()]);

export async function loadCities(): Promise<Sites> {
  const [[{ cities }], earth] = await Promise.all([fetchCities(), earthInfo()]);
  const detail = describe();
  const perRoot = kLargestRadius / Math.sqrt(cities[0][4]);
  const xyr = new Float64Array(3 * cities.length);
  const labels = cities.map(([name, country, x, y, population], k) => {
    xyr.set([x, y, perRoot * Math.sqrt(population)], 3 * k);
    return { name, detail: detail(country, population) };
  });
  const info: SetInfo = {
    key: "cities",
    title: "Cities of the world",
    about: "Circle area is population. Cells are computed on this flat map; distances are true.",
    credit: "cities",
    ...earth,
  };
  return new Sites(xyr, info, { labels });
}
