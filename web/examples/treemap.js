// A Voronoi treemap with curved cells: the world's economies, countries within regions. The area of
// each cell is its share, and its shape is the window of the cells inside it.
import { Diagram } from "apollonius-diagram";
import { hierarchy } from "d3-hierarchy";
import { select } from "d3-selection";

const width = 920,
  height = 480,
  rounds = 40;

/**
 * Fills a region with cells for the children of a node of d3-hierarchy, in proportion to their
 * values, and each of these with those of its own. Each gets `path`, `shape` (x, y, …), `area` and
 * `centre`.
 */
export function fill(node, region) {
  if (!node.children) return;
  // From the middle outwards, the largest first; then to and fro: areas, and round shapes.
  const { area, centroid } = new Diagram([0, 0, 0]).voronoi(region).cellMeasures(0);
  const reach = Math.sqrt(area / node.children.length) / 4;
  const diagram = Diagram.from(
    node.children,
    (_, k) => centroid[0] + reach * Math.sqrt(k) * Math.cos(2.4 * k),
    (_, k) => centroid[1] + reach * Math.sqrt(k) * Math.sin(2.4 * k),
    () => 0,
  );
  const cells = diagram.voronoi(region);
  const targets = node.children.map(({ value }) => value);
  for (let round = 0; round < rounds; ++round) {
    const { weights } = cells.fitAreas(targets, { tolerance: 0.01 });
    const centroids = cells.cellCentroids();
    const xyr = targets.flatMap((_, id) => [...centroids.slice(2 * id, 2 * id + 2), weights[id]]);
    diagram.updateMany(diagram.ids(), xyr);
  }
  cells.fitAreas(targets);
  node.children.forEach((child, id) => {
    child.path = cells.renderCell(id, null, { digits: 2 });
    child.shape = cells.cellPolygon(id, { tolerance: 0.01 });
    child.area = cells.cellArea(id);
    child.centre = cells.cellCentroid(id);
    fill(child, child.shape);
  });
  diagram.dispose();
}

/** Between an ellipse and a rectangle. */
const outline = Array.from({ length: 360 }, (_, k) => {
  const [c, s] = [Math.cos((k * Math.PI) / 180), Math.sin((k * Math.PI) / 180)];
  return [
    (width / 2) * (1 + 0.995 * Math.sign(c) * Math.abs(c) ** 0.5),
    (height / 2) * (1 + 0.99 * Math.sign(s) * Math.abs(s) ** 0.5),
  ];
});

const fontSize = ({ area, data }) => Math.sqrt(area) * Math.min(0.3, 1.4 / data.name.length);
const hues = [212, 4, 150, 42, 290, 85];

export default async function treemap(container) {
  const data = await (await fetch(new URL("../data/economies.json", import.meta.url))).json();
  const root = hierarchy(data)
    .sum(({ gdp }) => gdp)
    .sort((a, b) => b.value - a.value);
  fill(root, outline);

  const svg = select(container).append("svg").attr("viewBox", [0, 0, width, height]);
  const share = ({ value }) => `${((100 * value) / root.value).toPrecision(2)} %`;
  svg
    .selectAll("path")
    .data(root.leaves())
    .join("path")
    .attr("d", (d) => d.path)
    .attr("fill", (d) => {
      const hue = hues[root.children.indexOf(d.parent)];
      return `hsl(${hue} 55% ${88 - 22 * Math.sqrt(d.value / root.leaves()[0].value)}%)`;
    })
    .attr("stroke", "#fff")
    .append("title")
    .text((d) => `${d.data.name}: ${share(d)}\n${d.parent.data.name}: ${share(d.parent)}`);
  svg
    .append("g")
    .selectAll("path")
    .data(root.children)
    .join("path")
    .attr("d", (d) => d.path)
    .attr("fill", "none")
    .attr("stroke", "#fff")
    .attr("stroke-width", 4);
  svg
    .selectAll("text")
    .data(root.leaves().filter((d) => fontSize(d) > 5))
    .join("text")
    .attr("transform", (d) => `translate(${d.centre})`)
    .attr("text-anchor", "middle")
    .attr("dy", "0.35em")
    .attr("font-size", (d) => Math.min(24, fontSize(d)))
    .attr("pointer-events", "none")
    .text((d) => d.data.name);
  return { root };
}
