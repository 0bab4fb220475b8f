// Plotly: a bubble chart in WebGL that lights the bubble nearest to the pointer, or of several
// under it the smallest. In `scattergl` Plotly itself measures to the centres: far from the centre
// of a large bubble it finds nothing, or another one. (In `scatter`, which draws SVG and goes
// through all points, it measures to the rims.) plotly_click tells what is picked here. The diagram
// is of what is seen: pixels, made anew when the chart is zoomed or resized.
import { Diagram } from "apollonius-diagram";
import Plotly from "plotly.js-gl2d-dist-min";

const reach = 20; // pixels

/** Rows are [x, y, radius in pixels, name]. */
export default async function nearestInChart(container, rows) {
  const column = (k) => rows.map((row) => row[k]);
  const trace = {
    type: "scattergl",
    mode: "markers",
    x: column(0),
    y: column(1),
    text: column(3),
    hoverinfo: "text",
    marker: {
      size: column(2).map((r) => 2 * r),
      color: "#4e79a7",
      opacity: 0.8,
      line: { width: 0 },
    },
    selected: { marker: { color: "#e15759" } },
    unselected: { marker: { opacity: 0.8 } },
  };
  const chart = await Plotly.newPlot(
    container,
    [trace],
    { margin: { t: 40, r: 20, b: 40, l: 40 } },
    { scrollZoom: true },
  );

  let diagram = null;
  const place = () => {
    const { xaxis, yaxis } = chart._fullLayout;
    diagram?.dispose();
    diagram = Diagram.from(
      rows,
      ([x]) => xaxis.d2p(x),
      ([, y]) => yaxis.d2p(y),
      ([, , r]) => r,
    );
  };
  place();
  const watch = new ResizeObserver(() => Plotly.Plots.resize(container));
  watch.observe(container);

  let picked = -1;
  const label = () => {
    if (picked < 0) return Plotly.Fx.unhover(chart);
    // By its centre: `scattergl` finds none by number. Of equal centres it takes the last.
    const { xaxis, yaxis } = chart._fullLayout;
    const [x, y] = rows[picked];
    Plotly.Fx.hover(chart, [{ curveNumber: 0, xval: xaxis.d2c(x), yval: yaxis.d2c(y) }]);
  };
  chart.on("plotly_relayout", () => {
    place();
    label(); // which Plotly takes away then
  });
  const pick = async (id) => {
    if (id === picked) return;
    picked = id;
    await Plotly.restyle(chart, { selectedpoints: [id < 0 ? null : [id]] });
    if (id === picked) label();
  };
  // In place of Plotly's own search; the target is the plot without its axes.
  chart.on("plotly_beforehover", ({ type, clientX, clientY, target }) => {
    const { left, top } = target.getBoundingClientRect();
    pick(
      type === "mouseout"
        ? -1
        : diagram.pick(clientX - left, clientY - top, { maxDistance: reach }),
    );
    return false;
  });

  /** To be called when the chart goes. */
  const end = () => {
    watch.disconnect();
    Plotly.purge(container);
    diagram.dispose();
  };
  return { chart, picked: () => picked, end };
}
