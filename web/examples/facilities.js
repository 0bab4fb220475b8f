// Ambulances with different start-up times: who is there first? A start-up time is a negative
// weight: time = distance / speed + startUp.
import { Diagram } from "apollonius-diagram";
import { select } from "d3-selection";
import { randomCircles } from "./random_circles.js";

const width = 920,
  height = 480,
  speed = 60; // 60 units a minute

export default function facilities(container) {
  const stations = randomCircles(24, width, height, 0, 3, 13).map(({ x, y, r }) => ({
    x,
    y,
    startUp: r,
  })); // up to 3 minutes
  const diagram = Diagram.from(
    stations,
    (d) => d.x,
    (d) => d.y,
    (d) => -speed * d.startUp,
  );
  const areas = diagram.voronoi([0, 0, width, height]);
  // the others are nowhere first
  const ids = [...diagram.ids()].filter((id) => areas.cellArea(id) > 0);

  const svg = select(container).append("svg").attr("viewBox", [0, 0, width, height]);
  svg
    .selectAll("path")
    .data(ids)
    .join("path")
    .attr("d", (id) => areas.renderCell(id))
    .attr("fill", (id) => `hsl(${200 - 60 * stations[id].startUp} 60% 75%)`)
    .attr("stroke", "#fff");
  svg
    .selectAll("circle")
    .data(stations)
    .join("circle")
    .attr("cx", (d) => d.x)
    .attr("cy", (d) => d.y)
    .attr("r", 3)
    .attr("fill", (_, id) => (diagram.isHidden(id) ? "#aaa" : "#222"));
  svg
    .selectAll("text")
    .data(ids)
    .join("text")
    .attr("transform", (id) => `translate(${areas.cellCentroid(id)})`)
    .attr("text-anchor", "middle")
    .attr("dy", (id) => (areas.cellCentroid(id)[1] > stations[id].y ? 14 : -7))
    .attr("font-size", 11)
    .text((id) => `${((100 * areas.cellArea(id)) / (width * height)).toFixed(1)} %`);
  return { diagram, stations, areas };
}
