// A bubble chart with exact hover: d3-delaunay would pick the bubble whose centre is nearest, which
// often is not the one pointed at.
import { Diagram } from "apollonius-diagram";
import { pointer, select } from "d3-selection";
import { randomCircles } from "./random_circles.js";

const width = 920,
  height = 480;

export default function bubbleChart(container) {
  // large ones at the back
  const bubbles = randomCircles(90, width, height, 3, 90).sort((a, b) => b.r - a.r);
  const diagram = Diagram.from(bubbles); // ids are the rows

  const svg = select(container).append("svg").attr("viewBox", [0, 0, width, height]);
  const circles = svg
    .selectAll("circle")
    .data(bubbles)
    .join("circle")
    .attr("cx", (d) => d.x)
    .attr("cy", (d) => d.y)
    .attr("r", (d) => d.r)
    .attr("fill", "#4e79a7")
    .attr("fill-opacity", 0.25)
    .attr("stroke", "#4e79a7");

  /** The smallest bubble under the pointer; if there is none, the one whose rim is nearest. */
  const pick = (x, y) => diagram.pick(x, y);

  svg.on("pointermove pointerdown", (event) => {
    const picked = pick(...pointer(event));
    circles
      .attr("fill", (_, id) => (id === picked ? "#e15759" : "#4e79a7"))
      .attr("fill-opacity", (_, id) => (id === picked ? 0.7 : 0.25));
  });
  return { diagram, bubbles, pick };
}
