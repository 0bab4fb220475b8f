// Runs in a worker: random circles and their diagram, as a snapshot.
import { randomCircles } from "./random_sets.js";

const kPortions = 20;

self.onmessage = async ({ data: { address, options } }) => {
  try {
    self.postMessage({ share: 0, what: "Making circles" });
    const xyr = randomCircles(options);
    /** @type {typeof import("apollonius-diagram")} */
    const { Diagram } = await import(address);
    const diagram = new Diagram();
    const start = performance.now();
    const step = Math.ceil(xyr.length / 3 / kPortions);
    for (let k = 0; k < xyr.length; k += 3 * step) {
      self.postMessage({ share: k / xyr.length, what: "Building the diagram" });
      diagram.insertMany(xyr.subarray(k, k + 3 * step));
    }
    const buildTime = performance.now() - start;
    self.postMessage({ share: 1, what: "Handing it over" });
    const bytes = diagram.toBytes();
    self.postMessage({ xyr, bytes, buildTime }, { transfer: [xyr.buffer, bytes.buffer] });
  } catch (error) {
    self.postMessage({ error: String(error?.message ?? error) });
  }
};
