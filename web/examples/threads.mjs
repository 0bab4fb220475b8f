// For Node:  node threads.mjs
//
// One diagram, several threads. It is built once; each thread gets a copy of its snapshot, moved
// and not copied again, restores a diagram of its own in a fraction of the time of building, and
// answers its share of the points.
import { availableParallelism } from "node:os";
import { isMainThread, parentPort, Worker, workerData } from "node:worker_threads";
import { Diagram } from "apollonius-diagram";

if (isMainThread) {
  const random = (size) => Math.random() * size;
  const circles = Float64Array.from({ length: 3 * 100_000 }, (_, k) =>
    random(k % 3 === 2 ? 2 : 1000),
  );
  const points = Float64Array.from({ length: 2 * 1_000_000 }, () => random(1000));
  const diagram = new Diagram(circles);

  const snapshot = diagram.toBytes();
  const threads = availableParallelism();
  const share = 2 * Math.ceil(points.length / 2 / threads);
  const answers = await Promise.all(
    Array.from(
      { length: threads },
      (_, k) =>
        new Promise((resolve, reject) => {
          const bytes = snapshot.slice(),
            part = points.slice(k * share, (k + 1) * share);
          const worker = new Worker(new URL(import.meta.url), {
            workerData: { bytes, part },
            transferList: [bytes.buffer, part.buffer],
          });
          worker.once("message", resolve).once("error", reject);
        }),
    ),
  );

  const alone = diagram.findMany(points);
  const wrong = answers.flatMap((ids) => [...ids]).filter((id, k) => id !== alone[k]).length;
  console.log(
    `${threads} threads found the nearest of ${diagram.size} circles for ${alone.length} points; ` +
      `${wrong} differ from one thread's`,
  );
} else {
  // nobody else has had them
  const diagram = Diagram.fromBytes(workerData.bytes, { trusted: true });
  const ids = diagram.findMany(workerData.part);
  parentPort.postMessage(ids, [ids.buffer]);
}
