// Where is the most room between circles? The largest circles that touch none have their centres at
// vertices of the diagram.
import { Diagram } from "apollonius-diagram";
import { select } from "d3-selection";
import { randomCircles } from "./random_circles.js";

const width = 920,
  height = 480;

/**
 * The `count` largest circles that overlap neither the given ones nor each other, with centres in
 * the window.
 */
export function largestEmptyCircles(circles, width, height, count) {
  const diagram = Diagram.from(circles);
  const found = [];
  while (found.length < count) {
    const { coordinates, clearance } = diagram.vertices();
    let best = -1;
    clearance.forEach((r, k) => {
      const [x, y] = [coordinates[2 * k], coordinates[2 * k + 1]];
      if (x >= 0 && y >= 0 && x <= width && y <= height && (best < 0 || r > clearance[best]))
        best = k;
    });
    if (best < 0) break;
    const circle = { x: coordinates[2 * best], y: coordinates[2 * best + 1], r: clearance[best] };
    found.push(circle);
    diagram.insert(circle.x, circle.y, circle.r); // the next one has to stay clear of this one, too
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
