// A mark for Observable Plot: the cells of the circles that Plot.dot would draw. Its scales have
// turned the data into pixels by then, so the diagram is of what is seen.
import * as Plot from "@observablehq/plot";
import { Diagram } from "apollonius-diagram";
import { create } from "d3-selection";

/** Takes what Plot.dot takes, of which x, y and r count; stroke is the colour of the borders. */
export function cells(data, { stroke = "#bbb", ...options }) {
  return Plot.dot(data, {
    ...options,
    render(index, _scales, { x, y, r }, { width, height }) {
      const diagram = Diagram.from(
        index,
        (i) => x[i],
        (i) => y[i],
        (i) => r?.[i] ?? 3, // Plot's own
      );
      const path = diagram.voronoi([0, 0, width, height]).render();
      diagram.dispose();
      return create("svg:path").attr("fill", "none").attr("stroke", stroke).attr("d", path).node();
    },
  });
}

export default function plotMark(container, bubbles) {
  const channels = { x: "x", y: "y", r: "r" };
  const plot = Plot.plot({ marks: [cells(bubbles, channels), Plot.dot(bubbles, channels)] });
  container.append(plot);
  return plot;
}
