// d3-delaunay as a contender: nearest centre by walking, from the first point (no hint: queries are at random places).
import { Delaunay } from "d3-delaunay";
import { forEachUntil, forMilliseconds, readCentres, readQueries, sampled } from "./sampling.mjs";

let current = { set: "" };

function find(request) {
  if (request.set !== current.set) current = { set: request.set, delaunay: new Delaunay(readCentres(request.set)) };
  const { delaunay } = current;
  const points = readQueries(request);
  let sink = 0;
  const answer = sampled(request, points.length / 2, () => { sink = 0; }, () =>
    forEachUntil(request.limit, points.length / 2, (k) => { sink += delaunay.find(points[2 * k], points[2 * k + 1]); }));
  return { ...answer, sink };
}

export const operations = { find, findNear: find };

export function warmUp() {
  const delaunay = new Delaunay(Float64Array.from({ length: 2000 }, Math.random));
  forMilliseconds(300, () => delaunay.find(Math.random(), Math.random()));
}
