// Runs in a worker: random circles and their diagram, as a snapshot. Says that it is there; then
// each message has what to make, or nothing: then what is being made is given up. The diagram is
// built in slices, between which that is heard.
import { Diagram } from "apollonius-diagram";
import { randomCircles } from "./random_sets.js";

let building = new AbortController();

self.onmessage = ({ data: { job, options } }) => {
  building.abort();
  building = new AbortController();
  const tell = (message, rest) => self.postMessage({ ...message, job }, rest);
  if (options) make(options, building.signal, tell).catch((error) => tell(why(error)));
};
self.postMessage({ isReady: true });

async function make(options, signal, tell) {
  tell({ what: "Making circles" });
  const xyr = randomCircles(options);
  const onProgress = (share) => tell({ what: "Building the diagram", share });
  onProgress(0);
  const start = performance.now();
  const diagram = await Diagram.fromAsync(
    { length: options.count },
    (_, k) => xyr[3 * k],
    (_, k) => xyr[3 * k + 1],
    (_, k) => xyr[3 * k + 2],
    { signal, onProgress },
  );
  const buildTime = performance.now() - start;
  tell({ what: "Handing it over" });
  const bytes = diagram.toBytes();
  diagram.dispose();
  tell({ xyr, bytes, buildTime }, { transfer: [xyr.buffer, bytes.buffer] });
}

const why = (error) => ({ error: String(error?.message ?? error) });
