// The sphere: operations that the package and d3-geo-voronoi have in common. A set's circles are
// taken from the plane to the whole sphere, area for area; d3-geo-voronoi takes their centres.
import { boxOf, forEachUntil, readDoubles, readQueries, sampled } from "./sampling.mjs";

const kDegrees = 180 / Math.PI;

/** Places in a box as longitudes and latitudes, in the numbers of each `perItem`. */
export function toSphere(numbers, perItem, [xmin, ymin, xmax, ymax]) {
  return numbers.map((value, k) => {
    const axis = k % perItem;
    if (axis === 0) return (360 * (value - xmin)) / (xmax - xmin) - 180;
    if (axis === 1) return Math.asin((2 * (value - ymin)) / (ymax - ymin) - 1) * kDegrees;
    return value / Math.max(xmax - xmin, ymax - ymin);
  });
}

/**
 * `make(lonLatR)` builds a diagram, `end(diagram)` gives it back, `find(diagram, lon, lat)` is
 * asked for each point, `polygons(diagram)` makes all cells.
 */
export function sphereOperations({ make, end, find, polygons, others = {} }) {
  const kept = { set: "" };

  function load({ set }) {
    if (kept.set === set) return kept;
    if (kept.diagram !== undefined) end(kept.diagram);
    const sites = readDoubles(`${set}.sites`);
    const box = boxOf(sites, 3);
    return Object.assign(kept, { set, box, sites: toSphere(sites, 3, box), diagram: undefined });
  }

  function withDiagram(request) {
    const loaded = load(request);
    loaded.diagram ??= make(loaded.sites);
    return loaded;
  }

  const timed = (request, work) => {
    const { diagram, sites } = withDiagram(request);
    return sampled(request, sites.length / 3, () => void work(diagram));
  };

  return {
    sphereBuild(request) {
      const loaded = load(request);
      const prepare = () => {
        if (loaded.diagram !== undefined) end(loaded.diagram);
        loaded.diagram = undefined;
      };
      const build = () => {
        loaded.diagram = make(loaded.sites);
      };
      return sampled(request, loaded.sites.length / 3, build, prepare);
    },
    sphereFind(request) {
      const { diagram, box } = withDiagram(request);
      const points = toSphere(readQueries({ ...request, operation: "find" }), 2, box);
      const count = points.length / 2;
      const ask = (k) => void find(diagram, points[2 * k], points[2 * k + 1]);
      return sampled(request, count, () => forEachUntil(request.limit, count, ask));
    },
    spherePolygons: (request) => timed(request, polygons),
    ...Object.fromEntries(
      Object.entries(others).map(([name, work]) => [name, (request) => timed(request, work)]),
    ),
  };
}
