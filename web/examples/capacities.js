// Hospitals with so many beds each, on an island with a lake: each gets its share of the area. The
// weights that do it are found by fitAreas; borders between hospitals are where waiting is equal.
import { Diagram } from "apollonius-diagram";
import { select } from "d3-selection";
import { randomCircles } from "./random_circles.js";

const width = 920,
  height = 480;
const ring = (x, y, rx, ry, points, waves) =>
  Array.from({ length: points }, (_, k) => {
    const angle = (2 * Math.PI * k) / points;
    const r = 1 + 0.09 * Math.sin(waves * angle) + 0.05 * Math.sin((2 * waves + 1) * angle);
    return [x + rx * r * Math.cos(angle), y + ry * r * Math.sin(angle)];
  });
const coast = ring(460, 240, 390, 200, 240, 5);
const lake = ring(520, 230, 70, 35, 60, 3);

export default function capacities(container) {
  const hospitals = randomCircles(60, width, height, 20, 400, 29)
    .filter(({ x, y }) => ((x - 460) / 340) ** 2 + ((y - 240) / 170) ** 2 < 1)
    .map(({ x, y, r }) => ({ x, y, beds: Math.round(r) }));
  const diagram = Diagram.from(
    hospitals,
    (d) => d.x,
    (d) => d.y,
    () => 0,
  );
  const areas = diagram.voronoi([coast, lake]);
  const { error } = areas.fitAreas(hospitals.map(({ beds }) => beds));

  const svg = select(container).append("svg").attr("viewBox", [0, 0, width, height]);
  svg
    .selectAll("path")
    .data(hospitals)
    .join("path")
    .attr("d", (_, id) => areas.renderCell(id))
    .attr("fill", ({ beds }) => `hsl(160 40% ${88 - beds / 8}%)`)
    .attr("stroke", "#fff");
  svg.append("path").attr("d", areas.renderBounds()).attr("fill", "none").attr("stroke", "#367");
  svg
    .selectAll("text")
    .data(hospitals)
    .join("text")
    .attr("x", (d) => d.x)
    .attr("y", (d) => d.y)
    .attr("dy", 4)
    .attr("text-anchor", "middle")
    .attr("font-size", 11)
    .text(({ beds }) => beds);
  return { hospitals, areas, error };
}
