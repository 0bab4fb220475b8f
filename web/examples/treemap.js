// A Voronoi treemap with curved cells: the world's economies, countries within regions. The area of
// each cell is exactly its share.
import { treemap } from "apollonius-diagram/treemap";
import { hierarchy } from "d3-hierarchy";
import { select } from "d3-selection";

const width = 920,
  height = 480;

/** Between an ellipse and a rectangle. */
const outline = Array.from({ length: 360 }, (_, k) => {
  const [c, s] = [Math.cos((k * Math.PI) / 180), Math.sin((k * Math.PI) / 180)];
  return [
    (width / 2) * (1 + 0.995 * Math.sign(c) * Math.abs(c) ** 0.5),
    (height / 2) * (1 + 0.99 * Math.sign(s) * Math.abs(s) ** 0.5),
  ];
});

/** Where the name of a leaf fits into its cell, in which size: in the largest circle. */
function nameOf(leaf) {
  const { x, y, r } = leaf.label();
  return { leaf, x, y, size: (2 * r) / Math.hypot(1.2, 0.75 * leaf.data.name.length) };
}
const hues = [212, 4, 150, 42, 290, 85];

export default async function economies(container) {
  const data = await (await fetch(new URL("../data/economies.json", import.meta.url))).json();
  const tree = hierarchy(data)
    .sum(({ gdp }) => gdp)
    .sort((a, b) => b.value - a.value);
  const root = await treemap().shape(outline).async(tree);

  const svg = select(container).append("svg").attr("viewBox", [0, 0, width, height]);
  const share = ({ value }) => `${((100 * value) / root.value).toPrecision(2)} %`;
  const path = (d) => d.render(null, { digits: 2 });
  svg
    .selectAll("path")
    .data(root.leaves())
    .join("path")
    .attr("d", path)
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
    .attr("d", path)
    .attr("fill", "none")
    .attr("stroke", "#fff")
    .attr("stroke-width", 4);
  svg
    .selectAll("text")
    .data(
      root
        .leaves()
        .map(nameOf)
        .filter(({ size }) => size > 5),
    )
    .join("text")
    .attr("transform", (d) => `translate(${d.x}, ${d.y})`)
    .attr("text-anchor", "middle")
    .attr("dy", "0.35em")
    .attr("font-size", (d) => Math.min(24, d.size))
    .attr("pointer-events", "none")
    .text((d) => d.leaf.data.name);
  return { root };
}
