// d3-delaunay as a contender: nearest centre by walking, from the first point (no hint: queries are
// at random places); and drawing.
import { Delaunay } from "d3-delaunay";
import {
  boxOf,
  forEachUntil,
  forMilliseconds,
  readCentres,
  readQueries,
  sampled,
  Sum,
} from "./sampling.mjs";

let current = { set: "" };

function load({ set }) {
  if (set !== current.set) current = { set, delaunay: new Delaunay(readCentres(set)) };
  return current.delaunay;
}

function find(request) {
  const delaunay = load(request);
  const points = readQueries(request);
  let sink = 0;
  const answer = sampled(
    request,
    points.length / 2,
    () => {
      sink = 0;
    },
    () =>
      forEachUntil(request.limit, points.length / 2, (k) => {
        sink += delaunay.find(points[2 * k], points[2 * k + 1]);
      }),
  );
  return { ...answer, sink };
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
  let sum;
  const answer = sampled(
    request,
    points.length / 2,
    () => {
      sum = new Sum();
    },
    () => (known ?? delaunay.voronoi(bounds)).render(sum),
  );
  return { ...answer, sink: sum.value };
}

export const operations = { find, findNear: find, draw, redraw: draw };

export function warmUp() {
  const delaunay = new Delaunay(Float64Array.from({ length: 2000 }, Math.random));
  forMilliseconds(300, () => delaunay.find(Math.random(), Math.random()));
  forMilliseconds(300, () => delaunay.voronoi([0, 0, 1, 1]).render(new Sum()));
}
