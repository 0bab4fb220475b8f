// delaunator as a contender: the Delaunay triangulation of the centres, without radii, not dynamic.
import Delaunator from "delaunator";
import { forMilliseconds, readCentres, sampled } from "./sampling.mjs";

function build(request) {
  const centres = readCentres(request.set);
  return sampled(request, centres.length / 2, () => ({
    sink: new Delaunator(centres).triangles.length,
  }));
}

export const operations = { build };

export function warmUp() {
  forMilliseconds(
    700,
    (k) => new Delaunator(Float64Array.from({ length: k % 8 === 0 ? 20_000 : 2000 }, Math.random)),
  );
}
