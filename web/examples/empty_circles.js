// Where is the most room between circles? A largest circle that touches none has its centre at a
// vertex of the diagram, or, where centres have to be in a window, where an edge meets its border,
// or in a corner: along an edge, and along the border of a cell, the room is largest at an end.
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
  const corners = [0, 0, width, 0, width, height, 0, height];
  while (found.length < count) {
    const { curves } = diagram.voronoi([0, 0, width, height]).edgeCurves();
    const ends = [...corners];
    for (let k = 0; k < curves.length; k += 7)
      ends.push(curves[k], curves[k + 1], curves[k + 5], curves[k + 6]);
    const room = new Float64Array(ends.length / 2);
    diagram.findMany(ends, room);
    const best = room.indexOf(Math.max(...room));
    if (!(room[best] > 0)) break;
    const circle = { x: ends[2 * best], y: ends[2 * best + 1], r: room[best] };
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
