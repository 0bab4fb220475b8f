// A country divided among hospitals in its largest cities, to each as much land as it has beds. The
// beds are invented: the root of the city's population. The outline has two parts, on either side
// of the Bosporus.
// fitAreas finds weights, as head starts, with which the nearest hospital is the right one.
import { Diagram } from "apollonius-diagram";
import { select } from "d3-selection";

const data = async (name) => (await fetch(new URL(`../data/${name}.json`, import.meta.url))).json();

export default async function capacities(container) {
  const { outline, cities } = await data("country"); // km, y upwards
  for (const city of cities) city.beds = Math.round(Math.sqrt(city.people));
  const diagram = Diagram.from(
    cities,
    (d) => d.place[0],
    (d) => d.place[1],
    () => 0,
  );
  const areas = diagram.voronoi(outline);
  const { error } = areas.fitAreas(cities.map(({ beds }) => beds));

  const svg = select(container).append("svg").attr("viewBox", [-850, -380, 1700, 760]);
  const most = cities[0].beds;
  const map = svg.append("g").attr("transform", "scale(1 -1)");
  map
    .selectAll("path")
    .data(cities)
    .join("path")
    .attr("d", (_, id) => areas.renderCell(id))
    .attr("fill", ({ beds }) => `hsl(165 38% ${90 - 40 * (beds / most)}%)`)
    .attr("stroke", "#fff")
    .attr("stroke-width", 2)
    .append("title")
    .text(({ name, beds }) => `${name}: ${beds} beds`);
  map.append("path").attr("d", areas.renderBounds()).attr("fill", "none").attr("stroke", "#266");
  const city = svg
    .selectAll(".city")
    .data(cities)
    .join("g")
    .attr("class", "city")
    .attr("transform", ({ place: [x, y] }) => `translate(${x} ${-y})`);
  city.append("circle").attr("r", 4).attr("fill", "#123");
  city
    .append("text")
    .attr("dy", (_, k) => (isCrowded(cities, k) ? 24 : -9))
    .attr("text-anchor", "middle")
    .attr("font-size", 19)
    .attr("fill", "#123")
    .text(({ name }) => name);
  return { cities, areas, error };
}

/** Whether its name would meet that of a larger city beside it. */
const isCrowded = (cities, k) =>
  cities.slice(0, k).some(({ name, place: [x, y] }) => {
    const [x_, y_] = cities[k].place;
    const apart = 5 * (name.length + cities[k].name.length); // km, of letters
    return Math.abs(x - x_) < apart + 5 && Math.abs(y - y_) < 20;
  });
