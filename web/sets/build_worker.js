// Runs in a worker: random circles and their diagram, as a snapshot. Building is one call, as that
// is by far the fastest; how long it takes is estimated from a part of the circles. The first
// message has the package's address, each other one what to make.
import { randomCircles } from "./random_sets.js";

const kPart = 0.02;
const kSlower = 1.3; // all of them take longer for each than a part does

self.onmessage = async ({ data: { address } }) => {
  try {
    /** @type {typeof import("apollonius-diagram")} */
    const { Diagram } = await import(address);
    self.onmessage = ({ data: { options } }) => told(() => make(Diagram, options));
    self.postMessage({ isReady: true });
  } catch (error) {
    tellError(error);
  }
};

/** @param {typeof import("apollonius-diagram").Diagram} Diagram */
function make(Diagram, options) {
  self.postMessage({ what: "Making circles" });
  const xyr = randomCircles(options);
  const partTime = timeOf(() => new Diagram(xyr.subarray(0, 3 * partOf(xyr))).dispose());
  const estimate = (partTime * kSlower) / kPart;
  self.postMessage({ what: "Building the diagram", estimate });
  /** @type {import("apollonius-diagram").Diagram} */ let diagram;
  const buildTime = timeOf(() => {
    diagram = new Diagram(xyr);
  });
  self.postMessage({ what: "Handing it over" });
  const bytes = diagram.toBytes();
  diagram.dispose();
  self.postMessage({ xyr, bytes, buildTime }, { transfer: [xyr.buffer, bytes.buffer] });
}

const tellError = (error) => self.postMessage({ error: String(error?.message ?? error) });

function told(run) {
  try {
    run();
  } catch (error) {
    tellError(error);
  }
}

const partOf = (xyr) => Math.ceil((kPart * xyr.length) / 3);

function timeOf(run) {
  const start = performance.now();
  run();
  return performance.now() - start;
}
