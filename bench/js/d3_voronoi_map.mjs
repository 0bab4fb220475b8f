// d3-voronoi-map as a contender: cells of prescribed areas, of a power diagram (straight edges).
// It moves the sites, too, which makes cells rounder and the task another one.
import { voronoiMapSimulation } from "d3-voronoi-map";
import { boxOf, readCentres, sampled } from "./sampling.mjs";
import { deviationOf, sharesOf } from "./shares.mjs";

const kMostSteps = 200;
const kGoodEnough = 1e-4; // the sum of all deviations by the whole area: its own measure

const areaOf = (polygon) =>
  Math.abs(
    polygon.reduce((sum, [x, y], k) => {
      const [nextX, nextY] = polygon[(k + 1) % polygon.length];
      return sum + x * nextY - y * nextX;
    }, 0) / 2,
  );

/** Runs the simulation until it has converged, or the steps or the time are used up. */
function fitAreas(request) {
  const centres = readCentres(request.set);
  const shares = sharesOf(centres.length / 2, request.operation === "fitTailed");
  const [xmin, ymin, xmax, ymax] = boxOf(centres, 2);
  let state;
  const fit = () => {
    const simulation = voronoiMapSimulation(Array.from(shares, (weight, id) => ({ weight, id })))
      .clip([
        [xmin, ymin],
        [xmax, ymin],
        [xmax, ymax],
        [xmin, ymax],
      ])
      .initialPosition(({ id }) => [centres[2 * id], centres[2 * id + 1]])
      .minWeightRatio(1e-9)
      .convergenceRatio(kGoodEnough)
      .maxIterationCount(kMostSteps)
      .stop();
    const end = performance.now() + 1000 * request.limit;
    do simulation.tick();
    while (!simulation.state().ended && performance.now() < end);
    state = simulation.state();
  };
  const answer = sampled(request, shares.length, fit);
  const areas = new Float64Array(shares.length);
  for (const polygon of state.polygons)
    areas[polygon.site.originalObject.data.originalData.id] = areaOf(polygon);
  return { ...answer, deviation: deviationOf(areas, shares), steps: state.iterationCount };
}

export const operations = { fitAreas, fitTailed: fitAreas };
