// Runs in a worker: random circles and their diagram, as a snapshot. Says that it is there; then
// each message has what to make, or nothing: then what is being made is given up. The diagram is
// built in slices, between which that is heard.
import { Diagram } from "apollonius-diagram";
import { whenLoaded } from "../../shared/package.js";
import { messageOf } from "../../shared/errors.js";
import { type CircleOptions, randomCircles } from "../../shared/random_sets.js";

/** Circles to make; without `options` none. */
export type Job = { job?: number; options?: CircleOptions };
export type Built = { xyr: Float64Array; bytes: Uint8Array; buildTime: number };
/** Messages: once that the worker is there, then about a job. */
export type Told =
  | { kind: "ready" }
  | { kind: "progress"; job: number | undefined; what: string; share?: number }
  | { kind: "done"; job: number | undefined; built: Built }
  | { kind: "failed"; job: number | undefined; message: string };

let building = new AbortController();
const tell = (told: Told, transfer: Transferable[] = []) => self.postMessage(told, { transfer });

self.onmessage = ({ data: { job, options } }: MessageEvent<Job>) => {
  building.abort();
  building = new AbortController();
  if (!options) return;
  make(options, job, building.signal).catch((error) =>
    tell({ kind: "failed", job, message: messageOf(error) }),
  );
};
whenLoaded([]).then(() => tell({ kind: "ready" }));

async function make(options: CircleOptions, job: number | undefined, signal: AbortSignal) {
  const say = (what: string, share?: number) => tell({ kind: "progress", job, what, share });
  say("Making circles");
  const xyr = randomCircles(options);
  const onProgress = (share: number) => say("Building the diagram", share);
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
  say("Handing it over");
  const bytes = diagram.toBytes();
  diagram.dispose();
  tell({ kind: "done", job, built: { xyr, bytes, buildTime } }, [xyr.buffer, bytes.buffer]);
}
