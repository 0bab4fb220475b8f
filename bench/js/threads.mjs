// Threads that answer findMany, each from its own diagram restored from one snapshot
// (web/examples/threads.mjs is the short version).
import path from "node:path";
import { pathToFileURL } from "node:url";
import { isMainThread, parentPort, Worker } from "node:worker_threads";

/** The next message of a worker. */
function answerOf(worker) {
  return new Promise((resolve, reject) => {
    const settle = (done) => (value) => {
      worker.off("message", onMessage).off("error", onError);
      done(value);
    };
    const onMessage = settle(resolve),
      onError = settle(reject);
    worker.on("message", onMessage).on("error", onError);
  });
}

/** Starts this many threads and gives each the snapshot; resolves when all have restored it. */
export async function startFinders(threads, bytes) {
  const workers = Array.from({ length: threads }, () => new Worker(new URL(import.meta.url)));
  const ask = (worker, message, moved) => {
    const answer = answerOf(worker);
    worker.postMessage(message, moved);
    return answer;
  };
  await Promise.all(
    workers.map((worker) => {
      const own = bytes.slice();
      return ask(worker, { bytes: own }, [own.buffer]);
    }),
  );
  return {
    /** Sum of the ids that are found for x, y pairs. */
    async find(points) {
      const share = 2 * Math.ceil(points.length / 2 / threads);
      const found = await Promise.all(
        workers.map((worker, k) => {
          const part = points.slice(k * share, (k + 1) * share);
          return ask(worker, { points: part }, [part.buffer]);
        }),
      );
      return found.reduce((sum, ids) => ids.reduce((partial, id) => partial + id, sum), 0);
    },
    stop: () => Promise.all(workers.map((worker) => worker.terminate())),
  };
}

if (!isMainThread) {
  const { Diagram } = await import(
    pathToFileURL(path.join(process.env.BENCH_PACKAGE, "consumer.mjs")).href
  );
  let diagram;
  parentPort.on("message", ({ bytes, points }) => {
    if (bytes) {
      diagram = Diagram.fromBytes(bytes, { trusted: true });
      parentPort.postMessage(diagram.size);
    } else {
      const ids = diagram.findMany(points);
      parentPort.postMessage(ids, [ids.buffer]);
    }
  });
}
