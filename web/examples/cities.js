// Each city gets the land that is nearer to it than to any other, as far as the coast: the window
// is the outline of the world's land, 586 rings of 17 000 points, lakes among them.
import { Diagram } from "apollonius-diagram";
import { select } from "d3-selection";

const reach = 330; // km, of the largest city
const data = async (name) => (await fetch(new URL(`../data/${name}.json`, import.meta.url))).json();

/** A ring x, y, … in whole km, of which the file has a point and the steps to the next ones. */
function ringOf(steps) {
  const ring = [];
  for (let k = 0; k < steps.length; ++k) ring[k] = steps[k] + (k < 2 ? 0 : ring[k - 2]);
  return ring;
}

export default async function cities(container) {
  // Both are projected, to an equal-area map in km. A GeoJSON polygon that d3-geo-projection's
  // geoProject makes could be given as it is.
  const [{ cities, fields }, { land, outline }] = await Promise.all(["cities", "land"].map(data));
  const [x, y, people] = ["x", "y", "population"].map((name) => fields.indexOf(name));
  const largest = cities[0][people];
  const diagram = Diagram.from(
    cities,
    (d) => d[x],
    (d) => d[y],
    (d) => reach * Math.sqrt(d[people] / largest),
  );
  const cells = diagram.voronoi(land.map(ringOf));
  const areas = cells.cellAreas();

  const [west, south, east, north] = [-17500, -8650, 17500, 8650];
  const svg = select(container)
    .append("svg")
    .attr("viewBox", [west, -north, east - west, north - south])
    .attr("stroke-linejoin", "round");
  const map = svg.append("g").attr("transform", "scale(1 -1)"); // y upwards
  map
    .append("path")
    .attr("d", `M${pairs(ringOf(outline))}Z`)
    .attr("fill", "#edf2f5");
  const paths = map
    .selectAll(".city")
    .data(cities)
    .join("path")
    .attr("class", "city")
    .attr("d", (_, id) => cells.renderCell(id, null, { digits: 0, tolerance: 5 }))
    .attr("fill", (_, id) => colour(areas[id]))
    .attr("stroke", "#fff")
    .attr("stroke-width", 18);
  paths.append("title").text(([name], id) => `${name}: ${text(areas[id])}`);
  return { diagram, cells, cities, areas };
}

const pairs = (ring) => ring.join();
const text = (area) => `${Number(area.toPrecision(3)).toLocaleString("en")} km²`;

/** From red, where cities are close, to sand. */
function colour(area) {
  const t = Math.min(1, Math.max(0, Math.log10(area / 3e3) / 2.6));
  return `hsl(${12 + 32 * t} ${72 - 22 * t}% ${48 + 34 * t}%)`;
}
