// A temperature map: 40 stations, among them three lakes, each of which has one temperature all
// over. Between them the temperature is what their natural neighbours say: each station has a part
// in proportion to what a new one at that place would take from its cell.
import { Diagram } from "apollonius-diagram";
import { contours } from "d3-contour";
import { geoPath } from "d3-geo";
import { select } from "d3-selection";
import { randomCircles } from "./random_circles.js";

const width = 920,
  height = 480,
  step = 8; // pixels between the places that are asked for

/** One station in each of 8 x 5 fields, somewhere; warmer to the south, and on the west coast. */
function makeStations() {
  const places = randomCircles(40, 0.7, 0.7, 0, 1, 11);
  return places.map(({ x, y, r }, k) => {
    const place = { x: ((k % 8) + 0.15 + x) * 115, y: (Math.floor(k / 8) + 0.15 + y) * 96 };
    const lake = [12, 26, 29].includes(k) ? 34 : 0;
    const value = 6 + place.y / 60 + 5 * Math.exp(-place.x / 200) + 4 * r - (lake ? 3 : 0);
    return { ...place, r: lake, value: Math.round(10 * value) / 10 };
  });
}

export default function temperature(container) {
  const stations = makeStations();
  const diagram = Diagram.from(stations);
  // The map, and around it one square of the grid, so that its bands go on beyond the border.
  const cells = diagram.voronoi([-step, -step, width + step, height + step]);

  /** The temperature at a place, and the stations that it comes from. */
  const at = (x, y) => {
    const { ids, weights } = cells.naturalWeights(x, y);
    const value = ids.reduce((sum, id, k) => sum + weights[k] * stations[id].value, 0);
    return { value, ids, weights };
  };

  // In the middle of each square of the grid, as d3-contour has it.
  const [columns, rows] = [width / step + 2, height / step + 2];
  const middles = Array.from({ length: columns * rows }, (_, k) => [
    ((k % columns) - 0.5) * step,
    (Math.floor(k / columns) - 0.5) * step,
  ]);
  const measured = stations.map(({ value }) => value);
  const values = [...cells.interpolate(measured, middles.flat())];
  const [coldest, warmest] = [Math.min(...values), Math.max(...values)];
  const degrees = Array.from({ length: 40 }, (_, k) => k).filter((t) => t < warmest);
  const bands = contours().size([columns, rows]).thresholds(degrees)(values);

  /** From blue to red, with paper in the middle. */
  const colour = (value) => {
    const t = Math.min(1, Math.max(-1, (2 * (value - coldest)) / (warmest - coldest) - 1));
    return `hsl(${t < 0 ? 212 : 14} ${62 + 14 * t}% ${93 - 38 * Math.abs(t)}%)`;
  };
  const svg = select(container).append("svg").attr("viewBox", [0, 0, width, height]);
  svg
    .append("g")
    .attr("transform", `translate(${-step} ${-step}) scale(${step})`)
    .selectAll("path")
    .data(bands)
    .join("path")
    .attr("d", geoPath())
    .attr("fill", ({ value }) => colour(value + 0.5))
    .attr("stroke", "#555")
    .attr("stroke-opacity", 0.35)
    .attr("stroke-width", 1 / step);
  const rays = svg.append("g").attr("stroke", "#222").attr("stroke-linecap", "round");
  svg
    .selectAll("circle")
    .data(stations)
    .join("circle")
    .attr("cx", ({ x }) => x)
    .attr("cy", ({ y }) => y)
    .attr("r", ({ r }) => Math.max(r, 3))
    .attr("fill", ({ value }) => colour(value))
    .attr("stroke", "#222");
  const label = svg.append("text").attr("text-anchor", "middle").attr("font-size", 20);
  label.attr("paint-order", "stroke").attr("stroke", "#fff").attr("stroke-width", 4);

  const show = (x, y) => {
    const found = at(x, y);
    rays
      .selectAll("line")
      .data([...found.ids])
      .join("line")
      .attr("x1", x)
      .attr("y1", y)
      .attr("x2", (id) => stations[id].x)
      .attr("y2", (id) => stations[id].y)
      .attr("stroke-width", (_, k) => 14 * found.weights[k])
      .attr("stroke-opacity", 0.5);
    const place = [Math.min(width - 40, Math.max(40, x)), y < 40 ? y + 30 : y - 14];
    label
      .attr("x", place[0])
      .attr("y", place[1])
      .text(`${found.value.toFixed(1)} °C`);
    return found;
  };
  show(420, 250);
  svg.on("pointermove", ({ clientX, clientY }) => {
    const { left, top, width: shown } = svg.node().getBoundingClientRect();
    const scale = width / shown;
    show(
      Math.min(width, Math.max(0, (clientX - left) * scale)),
      Math.min(height, Math.max(0, (clientY - top) * scale)),
    );
  });
  return { stations, diagram, at, values, step, columns };
}
