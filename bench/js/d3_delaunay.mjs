// d3-delaunay as a contender: nearest centre by walking, from the first point (no hint: queries are
// at random places); and drawing.
import { Delaunay } from "d3-delaunay";
import { boxOf, forMilliseconds, readCentres, sampled, sampledQueries, Sum } from "./sampling.mjs";

let current = { set: "" };

function load({ set }) {
  if (set !== current.set) current = { set, delaunay: new Delaunay(readCentres(set)) };
  return current.delaunay;
}

function find(request) {
  const delaunay = load(request);
  return sampledQueries(
    request,
    (points) => (k) => delaunay.find(points[2 * k], points[2 * k + 1]),
  );
}

/**
 * All edges in the bounding box. `redraw`: from a Voronoi object made before, whose circumcenters
 * are known.
 */
function draw(request) {
  const delaunay = load(request);
  const { points } = delaunay;
  const bounds = boxOf(points, 2);
  const known = request.operation === "redraw" ? delaunay.voronoi(bounds) : undefined;
  return sampled(request, points.length / 2, () => {
    const sum = new Sum();
    (known ?? delaunay.voronoi(bounds)).render(sum);
    return { sink: sum.value };
  });
}

export const operations = { find, findNear: find, draw, redraw: draw };

export function warmUp() {
  const delaunay = new Delaunay(Float64Array.from({ length: 2000 }, Math.random));
  forMilliseconds(300, () => delaunay.find(Math.random(), Math.random()));
  forMilliseconds(300, () => delaunay.voronoi([0, 0, 1, 1]).render(new Sum()));
}
