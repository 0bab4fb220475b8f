// Makes random circles and their diagram: small sets at once, large ones in a worker, which says
// how far it is and can be stopped.
import { Diagram } from "apollonius-diagram";
import { type SetInfo, Sites } from "../model/sites.js";
import type { Built, Job, Told } from "./build_worker.js";
import { type CircleOptions, randomCircles } from "../../shared/random_sets.js";

/** Random circles: how many, hidden ones in per cent. */
export type RandomOptions = { n: number; hidden: number; seed: number; tall: boolean };
/** How far it is, if that is known, and the way to stop it. */
export type Watch = {
  signal?: AbortSignal;
  progress?: (share: number | undefined, what: string) => void;
};

const kMostHere = 100_000; // circles
const kArea = 1_600_000; // units squared of a random set
const kRatio = 1.6;

function circleOptions({ n, hidden, seed, tall }: RandomOptions): CircleOptions {
  const [long, short] = [Math.sqrt(kArea * kRatio), Math.sqrt(kArea / kRatio)];
  const [width, height] = tall ? [short, long] : [long, short];
  return { count: n, hiddenShare: hidden / 100, seed, width, height };
}

/** A worker that has loaded its code. */
function newWorker(): Promise<Worker> {
  const worker = new Worker(new URL("./build_worker.ts", import.meta.url), { type: "module" });
  return new Promise((resolve, reject) => {
    worker.onerror = (event) => reject(new Error(event.message || "its code cannot be loaded"));
    worker.onmessage = () => resolve(worker); // the first thing that it says
  });
}

let spare: Promise<Worker> | null = null;
let jobs = 0;

/** Gets the worker ready, so that building needs no network later. Resolves when it is. */
export async function prepareToBuild() {
  spare ??= newWorker();
  const starting = spare;
  try {
    await starting;
  } catch {
    if (spare === starting) spare = null; // there is another try when it is needed
  }
}

export async function build(options: RandomOptions, info: SetInfo, { signal, progress }: Watch) {
  if (options.n <= kMostHere) return new Sites(randomCircles(circleOptions(options)), info);
  const starting = spare ?? newWorker();
  spare = null; // it can be busy for long: another one takes what comes meanwhile
  const worker = await starting;
  const job = ++jobs;
  try {
    signal?.throwIfAborted();
    return await new Promise<Sites>((resolve, reject) => {
      signal?.addEventListener("abort", () => reject(signal.reason));
      worker.onerror = (event) => reject(new Error(event.message || "the worker failed"));
      worker.onmessage = ({ data: told }: MessageEvent<Told>) => {
        if (told.kind === "ready" || told.job !== job) return; // of one that was given up
        if (told.kind === "failed") reject(new Error(told.message));
        else if (told.kind === "done") resolve(restored(told.built, info));
        else progress?.(told.share, told.what);
      };
      worker.postMessage({ job, options: circleOptions(options) } satisfies Job);
    });
  } finally {
    release(worker);
  }
}

/** Gives back the worker's memory, and gets another one ready, if there is a way to one. */
function release(worker: Worker) {
  if (navigator.onLine) {
    worker.terminate();
    prepareToBuild();
  } else {
    worker.postMessage({} satisfies Job); // so that it gives up what it does
    spare = Promise.resolve(worker);
  }
}

function restored({ xyr, bytes, buildTime }: Built, info: SetInfo) {
  const diagram = Diagram.fromBytes(bytes, { trusted: true });
  return new Sites(xyr, info, { diagram, buildTime });
}
