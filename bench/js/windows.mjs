// The package's operations in windows: all areas in rings against the same in bounds, areas that
// are prescribed, values that are interpolated, and room for labels.
import path from "node:path";
import { holedRings, landRings, landRingsIn, starRing, thousandSegments } from "./land.mjs";
import { boxOf, readDoubles, sampled } from "./sampling.mjs";
import { deviationOf, sharesOf } from "./shares.mjs";

/** The rings of the land, moved into the box unless the sites are real cities. */
const landFor = ({ set }, box) => (/\bcities-/.test(set) ? landRings() : landRingsIn(box));

/** @param {typeof import("apollonius-diagram").Diagram} Diagram */
export function windowOperations(Diagram) {
  const kept = { set: "" };

  /** The diagram of a set, built once for several operations in a row. */
  function load({ set }) {
    if (kept.set === set) return kept;
    kept.diagram?.dispose();
    const sites = readDoubles(`${set}.sites`);
    Object.assign(kept, { set, sites, box: boxOf(sites, 3), diagram: new Diagram(sites) });
    return kept;
  }

  /**
   * Computes all areas of a diagram that has changed, as a drag does. `isFresh`: in a new window
   * each time.
   */
  function areasIn(windowOf, isFresh) {
    return (request) => {
      const { diagram, sites, box } = load(request);
      const window = windowOf(request, box);
      const known = diagram.voronoi(window);
      let isAside = false;
      let sum = 0;
      const move = () => {
        isAside = !isAside;
        diagram.update(0, sites[0] + (isAside ? 1e-6 * (box[2] - box[0]) : 0), sites[1], sites[2]);
      };
      const measure = () => {
        const cells = isFresh ? diagram.voronoi(window) : known;
        sum = cells.cellAreas().reduce((a, b) => a + b, 0);
      };
      const answer = sampled(request, sites.length / 3, measure, move);
      if (isAside) move();
      return { ...answer, sum, visible: diagram.visibleSize };
    };
  }

  /** Fits areas to shares, from equal weights, to the default tolerance. */
  function fitted(windowOf, isTailed) {
    return (request) => {
      const sites = readDoubles(`${request.set}.sites`).map((v, k) => (k % 3 === 2 ? 0 : v));
      const window = windowOf(request, boxOf(sites, 3));
      let diagram;
      let found;
      // A cell without a part of a window at equal weights cannot get one.
      const start = new Diagram(sites);
      const areas = start.voronoi(window).cellAreas();
      const inside = sites.filter((_, k) => areas[Math.floor(k / 3)] > 0);
      const shares = sharesOf(inside.length / 3, isTailed);
      start.dispose();
      const prepare = () => {
        diagram?.dispose();
        diagram = new Diagram(inside);
      };
      const fit = () => {
        found = diagram.voronoi(window).fitAreas(shares);
      };
      const answer = sampled(request, shares.length, fit, prepare);
      const deviation = deviationOf(diagram.voronoi(window).cellAreas(), shares);
      diagram.dispose();
      return { ...answer, deviation, steps: found.iterations };
    };
  }

  /** Interpolates at the pixels of a map of 500 x 500. */
  function interpolated(request) {
    const { diagram, box } = load(request);
    const [xmin, ymin, xmax, ymax] = box;
    const side = 500;
    const pixels = Float64Array.from({ length: 2 * side * side }, (_, k) => {
      const pixel = k >> 1;
      return k % 2 === 0
        ? xmin + (((pixel % side) + 0.5) / side) * (xmax - xmin)
        : ymin + ((Math.floor(pixel / side) + 0.5) / side) * (ymax - ymin);
    });
    const values = Array.from({ length: diagram.size }, (_, id) => id % 7);
    let found;
    const answer = sampled(request, side * side, () => {
      found = diagram.voronoi(box).interpolate(values, pixels);
    });
    return { ...answer, sum: found.reduce((a, b) => a + b, 0) };
  }

  /** Times a call that answers for all cells in bounds. */
  function ofCells(call) {
    return (request) => {
      const { diagram, sites, box } = load(request);
      const view = diagram.voronoi(box);
      return sampled(request, sites.length / 3, () => void call(view));
    };
  }

  /** The largest circle in a window of many points, which is one cell. */
  function starLabel({ set, seconds }) {
    const points = +path.basename(set).split("-")[1];
    const diagram = new Diagram([0, 0, 0]);
    const view = diagram.voronoi([starRing([-10, -10, 10, 10], points)]);
    const answer = sampled({ seconds }, 1, () => void view.cellCircle(0));
    diagram.dispose();
    return answer;
  }

  const box = (_, given) => given;
  const holes = (_, given) => holedRings(given);
  const segments = (_, given) => thousandSegments(given);
  return {
    fitAreas: fitted(box, false),
    fitTailed: fitted(box, true),
    fitInHoles: fitted(holes, false),
    fitTailedInHoles: fitted(holes, true),
    interpolate: interpolated,
    cellCircles: ofCells((view) => view.cellCircles()),
    toGeoJSON: ofCells((view) => view.toGeoJSON()),
    starLabel,
    boxAreas: areasIn(box, false),
    landAreas: areasIn(landFor, false),
    landAreasAnew: areasIn(landFor, true),
    segmentAreas: areasIn(segments, false),
    segmentAreasAnew: areasIn(segments, true),
  };
}
