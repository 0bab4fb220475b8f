// Vega-Lite: with this patch for vega-embed, `nearest: true` takes the symbol whose rim is nearest,
// at most 20 pixels away, or of several under the pointer the smallest. Vega-Lite itself takes the
// one whose centre is nearest, however far away. With a stroke, the cells are drawn, too.
//
//   embed(container, spec, { patch: byCircles({ stroke: "#bbb" }) });
//
// Its transform "circlecells" is for specs of Vega, too. It takes what Vega's own "voronoi" takes,
// and radii. Vega calls it when the symbols change: cells are of what is seen, in pixels.
import { Diagram } from "apollonius-diagram";
import { Transform, transforms } from "vega";
import embed from "vega-embed";

/**
 * Adds to each item the path of its cell. With a reach it is the path of where diagram.pick(x, y,
 * reach) would pick the item, if items are drawn from the largest to the smallest: the cell up to
 * that distance, and the circle.
 */
class CircleCells extends Transform {
  static Definition = {
    type: "CircleCells",
    metadata: { modifies: true },
    params: [
      { name: "x", type: "field", required: true },
      { name: "y", type: "field", required: true },
      { name: "r", type: "field", required: true },
      { name: "size", type: "number", array: true, length: 2, required: true },
      { name: "reach", type: "number" },
      { name: "as", type: "string", default: "path" },
    ],
  };

  constructor(params) {
    super(null, params);
  }

  transform({ x, y, r, size, reach, as = "path" }, pulse) {
    const circles = pulse.source.map((item) => [x(item), y(item), r(item)]);
    // Another colour, say, does not move the cells.
    const given = String([size, reach, as, circles]);
    if (given === this.value && !pulse.changed(pulse.ADD_REM)) return pulse;
    this.value = given;

    const diagram = Diagram.from(circles);
    const [width, height] = size;
    const paths = diagram.voronoi([0, 0, width, height], { maxDistance: reach }).renderCells();
    for (const [id, item] of pulse.source.entries())
      item[as] = reach === undefined ? paths[id] : (paths[id] ?? "") + circlePath(circles[id]);
    diagram.dispose();
    return pulse.reflow(true).modifies(as);
  }
}
transforms.circlecells = /** @type {any} */ (CircleCells);

/** It turns as cells do: where both are, they do not cancel each other. */
const circlePath = ([x, y, r]) =>
  `M${x - r},${y}a${r},${r},0,1,1,${2 * r},0a${r},${r},0,1,1,${-2 * r},0Z`;

/** A patch of the Vega spec that Vega-Lite makes. */
export function byCircles({ reach = 20, stroke = null } = {}) {
  const patched = (mark) => {
    const nearest = mark.transform?.find(({ type }) => type === "voronoi");
    if (!nearest) return [mark];
    const r = { expr: "sqrt(datum.datum.size) / 2" }; // datum: the symbol
    const cells = { ...nearest, type: "circlecells", r };
    const drawn = {
      type: "path",
      from: mark.from,
      interactive: false,
      clip: true,
      encode: { update: { stroke: { value: stroke } } },
      transform: [cells],
    };
    const sort = { field: "datum.size", order: "descending" };
    const asked = { ...mark, clip: true, sort, transform: [{ ...cells, reach }] };
    return stroke ? [drawn, asked] : [asked];
  };
  // Marks of facets are in marks.
  const revive = (key, value) => (key === "marks" ? value.flatMap(patched) : value);
  return (spec) => JSON.parse(JSON.stringify(spec), revive);
}

/** Rows are { x, y, r, name }, with r in pixels. */
export default function nearestInChart(container, rows) {
  const scale = { zero: false, padding: 40 };
  const select = { type: "point", on: "mouseover", clear: "mouseout", nearest: true };
  const spec = {
    width: "container",
    height: "container",
    data: { values: rows },
    transform: [{ calculate: "pow(2 * datum.r, 2)", as: "size" }],
    mark: { type: "circle", opacity: 0.8 },
    params: [
      { name: "picked", select },
      { name: "zoom", select: "interval", bind: "scales" },
    ],
    encoding: {
      x: { field: "x", type: "quantitative", scale },
      y: { field: "y", type: "quantitative", scale },
      size: { field: "size", type: "quantitative", scale: null },
      order: { field: "size", sort: "descending" }, // small ones are drawn last
      tooltip: { field: "name" },
      color: { value: "#4e79a7", condition: { param: "picked", empty: false, value: "#e15759" } },
    },
  };
  const patch = byCircles({ stroke: "#bbb" });
  return embed(container, /** @type {any} */ (spec), { patch, actions: false });
}
