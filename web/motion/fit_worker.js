// Runs in a worker: the radii with which all cells in a window have the same area. Only their
// differences count, so they are made as large as they can be without overlaps; some may be
// negative then.
import { Diagram } from "apollonius-diagram";

const kMostSteps = 300; // cities, which crowd, take 100 to 150

self.onmessage = ({ data: { xyr, window } }) => {
  try {
    const diagram = new Diagram(xyr);
    const targets = new Uint8Array(xyr.length / 3).fill(1);
    const { weights } = diagram.voronoi(window).fitAreas(targets, {
      maxIterations: kMostSteps,
      strict: true,
      onIteration: (progress) => self.postMessage(progress),
    });
    const gap = leastGap(diagram.edges().sites, xyr, weights);
    self.postMessage({ result: weights.map((weight) => weight + gap / 2) });
  } catch (error) {
    self.postMessage({ failure: String(error?.message ?? error), code: error?.code });
  }
};

/** Between the rims of neighbours: less than nothing if they overlap. */
function leastGap(pairs, xyr, radii) {
  let least = Infinity;
  for (let k = 0; k < pairs.length; k += 2) {
    const [i, j] = [pairs[k], pairs[k + 1]];
    const apart = Math.hypot(xyr[3 * i] - xyr[3 * j], xyr[3 * i + 1] - xyr[3 * j + 1]);
    least = Math.min(least, apart - radii[i] - radii[j]);
  }
  return least;
}
