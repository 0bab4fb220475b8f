// Ambulances with different start-up times: who is there first? A start-up time is a negative weight: time = distance / speed + startUp.
import { Diagram } from "apollonius-diagram";
import { select } from "d3-selection";
import { randomCircles } from "./random_circles.js";

const width = 920, height = 480, speed = 60;  // 60 units a minute

export default function facilities(container) {
  const stations = randomCircles(24, width, height, 0, 3, 13).map(({ x, y, r }) => ({ x, y, startUp: r }));  // up to 3 minutes
  const diagram = Diagram.from(stations, (d) => d.x, (d) => d.y, (d) => -speed * d.startUp);
  const areas = diagram.voronoi([0, 0, width, height]);

  const svg = select(container).append("svg").attr("viewBox", [0, 0, width, height]);
  svg.selectAll("path").data(stations).join("path").attr("d", (_, id) => areas.renderCell(id))
    .attr("fill", (d) => `hsl(${200 - 60 * d.startUp} 60% 75%)`).attr("stroke", "#fff");
  svg.selectAll("circle").data(stations).join("circle").attr("cx", (d) => d.x).attr("cy", (d) => d.y).attr("r", 3);
  svg.selectAll("text").data(stations).join("text").attr("x", (d) => d.x + 6).attr("y", (d) => d.y + 4).attr("font-size", 11)
    .text((_, id) => (diagram.isHidden(id) ? "never first" : `${(100 * areas.cellArea(id) / (width * height)).toFixed(1)} %`));
  return { diagram, stations, areas };
}
