// The path between discs whose narrowest passage is as wide as can be runs along the edges of the diagram.
import { Diagram } from "apollonius-diagram";
import { select } from "d3-selection";
import { randomCircles } from "./random_circles.js";

const width = 920, height = 480;

/**
 * From the vertex next to `start` to the one next to `goal` by vertices for which `isInside` holds: the points on the way, and the
 * clearance where it is narrowest; null if there is no way.
 */
export function widestPath(diagram, start, goal, isInside = () => true) {
  const { coordinates, clearance } = diagram.vertices();
  const { sites, vertices } = diagram.edges();
  const roads = Array.from(clearance, () => []);
  for (let k = 0; k < vertices.length; k += 2) {
    const [from, to] = [vertices[k], vertices[k + 1]];
    if (![from, to].every((v) => v >= 0 && isInside(coordinates[2 * v], coordinates[2 * v + 1]))) continue;  // -1: unbounded
    // On an edge of sites a and b the clearance is smallest where it crosses the line of their centres; else at an end.
    const [a, b] = [diagram.site(sites[k]), diagram.site(sites[k + 1])];
    const side = (v) => (b.x - a.x) * (coordinates[2 * v + 1] - a.y) - (b.y - a.y) * (coordinates[2 * v] - a.x);
    const distance = Math.hypot(b.x - a.x, b.y - a.y), gap = (distance - a.r - b.r) / 2;
    const isBetween = side(from) * side(to) < 0;
    const width = isBetween ? gap : Math.min(clearance[from], clearance[to]);
    if (width <= 0) continue;
    const share = (a.r + gap) / distance;
    const via = isBetween ? [[a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share]] : [];
    roads[from].push({ next: to, width, via });
    roads[to].push({ next: from, width, via });
  }
  const nextTo = ([x, y]) => clearance.reduce((best, _, v) => {
    const distance = Math.hypot(coordinates[2 * v] - x, coordinates[2 * v + 1] - y);
    return roads[v].length > 0 && distance < best.distance ? { v, distance } : best;
  }, { v: -1, distance: Infinity }).v;

  // Dijkstra's algorithm with the narrowest passage so far in place of the length.
  const [first, last] = [nextTo(start), nextTo(goal)];
  const widest = new Float64Array(clearance.length), before = [], open = new Set([first]);
  widest[first] = clearance[first];
  while (open.size > 0) {
    const v = [...open].reduce((a, b) => (widest[b] > widest[a] ? b : a));
    if (v === last) break;
    open.delete(v);
    for (const { next, width, via } of roads[v]) {
      const passage = Math.min(widest[v], width);
      if (passage <= widest[next]) continue;
      widest[next] = passage;
      before[next] = { v, via };
      open.add(next);
    }
  }
  if (widest[last] === 0) return null;
  const path = [];
  for (let v = last; v !== undefined; v = v === first ? undefined : before[v].v) {
    path.unshift(...(v === first ? [] : before[v].via), [coordinates[2 * v], coordinates[2 * v + 1]]);
  }
  return { path, clearance: widest[last] };
}

export default function clearancePath(container) {
  const circles = randomCircles(150, width, height, 4, 44, 5);
  const diagram = Diagram.from(circles);
  const found = widestPath(diagram, [0, height / 2], [width, height / 2],
                           (x, y) => x >= 0 && x <= width && y >= 0 && y <= height);
  const svg = select(container).append("svg").attr("viewBox", [0, 0, width, height]);
  svg.selectAll("circle").data(circles).join("circle").attr("cx", (d) => d.x).attr("cy", (d) => d.y).attr("r", (d) => d.r).attr("fill", "#bab0ac");
  svg.append("polyline").attr("points", found.path.join(" ")).attr("fill", "none").attr("stroke", "#e15759")
    .attr("stroke-width", 2).attr("stroke-linejoin", "round");
  return { circles, ...found };
}
