// Chart.js: an interaction mode for bubble charts, "circle": the smallest bubble under the pointer,
// or else the one whose rim is nearest. The mode "nearest" takes the one whose centre is nearest.
//
//   import circleMode from "./chartjs.js";
//   Chart.register(circleMode);
//   new Chart(canvas, { type: "bubble", data, options: { interaction: { mode: "circle" } } });
//
// With `intersect: true`, which is Chart.js' default, the pointer has to be in a bubble. Scatter
// and line charts have radii, too.
import { Diagram } from "apollonius-diagram";
import { Interaction } from "chart.js";
import { getRelativePosition } from "chart.js/helpers";

/** By chart, until it draws again: the diagram of its elements in pixels, and these by id. */
const layouts = new WeakMap();

function layoutOf(chart, isFinal) {
  if (layouts.has(chart)) return layouts.get(chart);
  const items = chart.getSortedVisibleDatasetMetas().flatMap(({ index: datasetIndex, data }) =>
    data.flatMap((element, index) => {
      const { x, y, skip } = element.getProps(["x", "y", "skip"], isFinal);
      const isShown = !skip && Number.isFinite(x) && Number.isFinite(y);
      return isShown ? [{ element, datasetIndex, index, x, y, r: element.options.radius }] : [];
    }),
  );
  const layout = { items, diagram: Diagram.from(items) };
  layouts.set(chart, layout);
  return layout;
}

const forget = (chart) => layouts.delete(chart);
export default { id: "circle", afterUpdate: forget, afterDraw: forget };

/** @type {any} */ (Interaction.modes).circle = (chart, event, { intersect }, isFinal) => {
  const { x, y } = getRelativePosition(event, chart);
  if (!chart.isPointInArea({ x, y })) return [];
  const { items, diagram } = layoutOf(chart, isFinal);
  const id = diagram.pick(x, y, { maxDistance: intersect ? 0 : Infinity });
  return id < 0 ? [] : [items[id]];
};
