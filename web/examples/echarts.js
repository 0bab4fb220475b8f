// ECharts: a bubble chart that lights the bubble nearest to the pointer, or of several under it the
// smallest. ECharts itself takes the one drawn last, and nothing beside a bubble. The diagram is of
// what is seen: pixels, as convertToPixel gives them, made anew when the chart is zoomed or
// resized.
import { Diagram } from "apollonius-diagram";
import { ScatterChart } from "echarts/charts";
import { DataZoomComponent, GridComponent, TooltipComponent } from "echarts/components";
import { init, use } from "echarts/core";
import { CanvasRenderer } from "echarts/renderers";

use([ScatterChart, GridComponent, TooltipComponent, DataZoomComponent, CanvasRenderer]);

const reach = 20; // pixels

/** Rows are [x, y, radius in pixels, name]. */
export default function nearestInChart(container, rows) {
  const chart = init(container);
  chart.setOption({
    animation: false,
    xAxis: { scale: true },
    yAxis: { scale: true },
    dataZoom: { type: "inside" },
    // Shown by showTip only, and bubbles do not answer the pointer: the diagram does.
    tooltip: { triggerOn: "none", formatter: ({ value }) => value[3] },
    series: {
      type: "scatter",
      silent: true,
      data: rows,
      symbolSize: ([, , r]) => 2 * r,
      itemStyle: { color: "#4e79a7", opacity: 0.8 },
      emphasis: { itemStyle: { color: "#e15759" } },
    },
  });

  let diagram = null;
  const place = () => {
    const points = rows.map(([x, y]) => chart.convertToPixel({ seriesIndex: 0 }, [x, y]));
    diagram?.dispose();
    diagram = Diagram.from(
      points,
      ([x]) => x,
      ([, y]) => y,
      (_, id) => rows[id][2],
    );
  };
  place();
  chart.on("datazoom", place);
  const watch = new ResizeObserver(() => {
    chart.resize();
    place();
  });
  watch.observe(container);

  let picked = -1;
  const pick = (id) => {
    if (id === picked) return;
    chart.dispatchAction({ type: "downplay", seriesIndex: 0, dataIndex: picked });
    picked = id;
    if (id < 0) chart.dispatchAction({ type: "hideTip" });
    else
      for (const type of ["highlight", "showTip"])
        chart.dispatchAction({ type, seriesIndex: 0, dataIndex: id });
  };
  const pointer = chart.getZr();
  pointer.on("mousemove", ({ offsetX, offsetY }) =>
    pick(diagram.pick(offsetX, offsetY, { maxDistance: reach })),
  );
  pointer.on("globalout", () => pick(-1));

  /** To be called when the chart goes. */
  const end = () => {
    watch.disconnect();
    chart.dispose();
    diagram.dispose();
  };
  return { chart, picked: () => picked, end };
}
