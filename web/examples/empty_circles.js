// Where is the most room between circles? Where the largest empty circle is. Then that one is
// taken, too, and the next one has to stay clear of it.
import { Diagram } from "apollonius-diagram";
import { select } from "d3-selection";
import { randomCircles } from "./random_circles.js";

const width = 920,
  height = 480;

/** The `count` largest circles in the window that overlap neither the given ones nor each other. */
export function largestEmptyCircles(circles, width, height, count) {
  const diagram = Diagram.from(circles);
  const window = diagram.voronoi([0, 0, width, height]); // always of the diagram as it is now
  const found = [];
  while (found.length < count) {
    const { x, y, r } = window.largestEmptyCircle({ inside: true });
    if (!(r > 0)) break;
    found.push({ x, y, r });
    diagram.insert(x, y, r);
  }
  diagram.dispose();
  return found;
}

export default function emptyCircles(container) {
  const circles = randomCircles(120, width, height, 4, 60, 11);
  const empty = largestEmptyCircles(circles, width, height, 12);
  const svg = select(container).append("svg").attr("viewBox", [0, 0, width, height]);
  svg
    .selectAll("circle")
    .data([...circles, ...empty])
    .join("circle")
    .attr("cx", (d) => d.x)
    .attr("cy", (d) => d.y)
    .attr("r", (d) => d.r)
    .attr("fill", (_, k) => (k < circles.length ? "#bab0ac" : "#59a14f"))
    .attr("fill-opacity", (_, k) => (k < circles.length ? 1 : 0.6));
  return { circles, empty };
}
