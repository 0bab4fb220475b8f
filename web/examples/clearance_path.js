// The path between discs whose narrowest passage is as wide as can be runs along the edges of the
// diagram.
import { curvePoint, Diagram } from "apollonius-diagram";
import { select } from "d3-selection";
import { randomCircles } from "./random_circles.js";

const width = 920,
  height = 480;

/**
 * From the vertex next to `start` to the one next to `goal` inside the bounds: points on the way,
 * and the clearance where it is narrowest; null if there is no way.
 */
export function widestPath(diagram, bounds, start, goal) {
  // Places are vertices of the diagram, and points where its edges leave the window.
  const view = diagram.voronoi(bounds);
  const { xy } = view.vertices();
  const { vertices, clearance } = view.edges({ clearance: true });
  const { curves } = view.edgeCurves();
  const roads = Array.from({ length: xy.length / 2 }, () => []);
  clearance.forEach((width, k) => {
    if (width <= 0) return;
    const points = Array.from({ length: 21 }, (_, i) => curvePoint(curves, k, i / 20));
    const [from, to] = vertices.subarray(2 * k, 2 * k + 2);
    roads[from].push({ to, width, points });
    roads[to].push({ to: from, width, points: points.toReversed() });
  });
  const places = [...roads.keys()].filter((place) => roads[place].length > 0);
  const nearest = ([x, y]) => {
    const distance = (place) => Math.hypot(xy[2 * place] - x, xy[2 * place + 1] - y);
    return places.reduce((a, b) => (distance(b) < distance(a) ? b : a));
  };

  // Dijkstra's algorithm with the narrowest passage so far in place of the length.
  const [first, last] = [nearest(start), nearest(goal)];
  const reached = new Map([[first, { width: Infinity, path: [] }]]),
    open = new Set([first]);
  while (open.size > 0) {
    const place = [...open].reduce((a, b) => (reached.get(b).width > reached.get(a).width ? b : a));
    const { width, path } = reached.get(place);
    if (place === last) return { path: path.flat(), clearance: width };
    open.delete(place);
    for (const road of roads[place]) {
      const passage = Math.min(width, road.width);
      if (passage <= (reached.get(road.to)?.width ?? 0)) continue;
      reached.set(road.to, { width: passage, path: [...path, road.points] });
      open.add(road.to);
    }
  }
  return null;
}

export default function clearancePath(container) {
  const circles = randomCircles(150, width, height, 4, 44, 5);
  const diagram = Diagram.from(circles);
  const found = widestPath(diagram, [0, 0, width, height], [0, height / 2], [width, height / 2]);
  const svg = select(container).append("svg").attr("viewBox", [0, 0, width, height]);
  svg
    .append("path")
    .attr("d", diagram.voronoi([0, 0, width, height]).render(null, { digits: 2 }))
    .attr("fill", "none")
    .attr("stroke", "#e3e0da");
  svg
    .selectAll("circle")
    .data(circles)
    .join("circle")
    .attr("cx", (d) => d.x)
    .attr("cy", (d) => d.y)
    .attr("r", (d) => d.r)
    .attr("fill", "#bab0ac");
  svg
    .append("polyline")
    .attr("points", found.path.join(" "))
    .attr("fill", "none")
    .attr("stroke", "#e15759")
    .attr("stroke-width", 2)
    .attr("stroke-linejoin", "round");
  return { circles, ...found };
}
