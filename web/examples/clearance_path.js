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
  // Places are ends of curves: vertices of the diagram, and points where its edges leave the
  // window.
  const { curves, sites } = diagram.voronoi(bounds).edgeCurves();
  const roads = new Map();
  const addRoad = (from, road) =>
    roads.has(`${from}`) ? roads.get(`${from}`).push(road) : roads.set(`${from}`, [road]);
  for (let k = 0; k < sites.length / 2; ++k) {
    const ends = [0, 1].map((t) => curvePoint(curves, k, t));
    // Along the edge of sites a and b the clearance is smallest where it crosses the line of their
    // centres; else at an end.
    const [a, b] = [diagram.site(sites[2 * k]), diagram.site(sites[2 * k + 1])];
    const [from, to] = ends.map(([x, y]) => (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x));
    const gap = (Math.hypot(b.x - a.x, b.y - a.y) - a.r - b.r) / 2;
    const width =
      from * to < 0 ? gap : Math.min(...ends.map(([x, y]) => Math.hypot(x - a.x, y - a.y) - a.r));
    if (width <= 0) continue;
    const points = Array.from({ length: 21 }, (_, i) => curvePoint(curves, k, i / 20));
    addRoad(ends[0], { to: ends[1], width, points });
    addRoad(ends[1], { to: ends[0], width, points: points.toReversed() });
  }
  const nearest = ([x, y]) => {
    const distance = (place) => Math.hypot(place.split(",")[0] - x, place.split(",")[1] - y);
    return [...roads.keys()].reduce((a, b) => (distance(b) < distance(a) ? b : a));
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
    for (const road of roads.get(place)) {
      const passage = Math.min(width, road.width);
      if (passage <= (reached.get(`${road.to}`)?.width ?? 0)) continue;
      reached.set(`${road.to}`, { width: passage, path: [...path, road.points] });
      open.add(`${road.to}`);
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
