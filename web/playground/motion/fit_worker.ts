// Runs in a worker: the radii with which all cells in a window have the same area. Only their
// differences count, so they are made as large as they can be without overlaps; some may be
// negative then.
import { ApolloniusError, Diagram, type FitProgress } from "apollonius-diagram";
import { whenLoaded } from "../../figure/package.js";
import { messageOf } from "../errors.js";
import type { Window } from "../model/sites.js";
import type { Told } from "./in_worker.js";

/** The circles x, y, r, and where their cells end. */
export type FitRequest = { xyr: Float64Array; window: Window };
export type FitTold = Told<Float64Array, FitProgress>;

const tell = (told: FitTold) => self.postMessage(told);

const kMostSteps = 300; // cities, which crowd, take 100 to 150

self.onmessage = async ({ data: { xyr, window } }: MessageEvent<FitRequest>) => {
  try {
    await whenLoaded(["shapes"]);
    const diagram = new Diagram(xyr);
    const targets = new Uint8Array(xyr.length / 3).fill(1);
    const fitted = diagram.voronoi(window).fitAreas(targets, {
      maxIterations: kMostSteps,
      strict: true,
      onIteration: (progress) => tell({ kind: "progress", progress }),
    });
    if (!fitted) throw new Error("no cell has an area");
    const { weights } = fitted;
    const gap = leastGap(diagram.edges().sites, xyr, weights);
    tell({ kind: "result", result: weights.map((weight) => weight + gap / 2) });
  } catch (error) {
    const code = error instanceof ApolloniusError ? error.code : undefined;
    tell({ kind: "failure", message: messageOf(error), code });
  }
};

/** Between the rims of neighbours: less than nothing if they overlap. */
function leastGap(pairs: ArrayLike<number>, xyr: Float64Array, radii: Float64Array) {
  let least = Infinity;
  for (let k = 0; k < pairs.length; k += 2) {
    const [i, j] = [pairs[k], pairs[k + 1]];
    const apart = Math.hypot(xyr[3 * i] - xyr[3 * j], xyr[3 * i + 1] - xyr[3 * j + 1]);
    least = Math.min(least, apart - radii[i] - radii[j]);
  }
  return least;
}
