// Lloyd's relaxation with areas that are given: sites move to the centroids of their cells, and
// fitAreas makes the areas right again, which takes two or three steps from the last weights.
import { Diagram } from "apollonius-diagram";
import { randomCircles } from "./random_circles.js";

const width = 920,
  height = 480,
  rounds = 150;

/**
 * Relaxes the sites of a diagram, ids 0, 1, 2, …, within a region, one round a frame. Rejects if
 * the signal is aborted; the diagram then is as the last round has left it.
 */
export async function relax(diagram, region, targets, { rounds, signal, onProgress }) {
  const cells = diagram.voronoi(region);
  const ids = diagram.ids();
  const xyr = new Float64Array(3 * ids.length);
  let { weights } = cells.fitAreas(targets);
  for (let round = 1; round <= rounds; ++round) {
    await new Promise(requestAnimationFrame);
    signal?.throwIfAborted();
    const centroids = cells.cellCentroids();
    for (const id of ids) {
      xyr.set([centroids[2 * id], centroids[2 * id + 1], weights[id]], 3 * id);
    }
    diagram.updateMany(ids, xyr);
    ({ weights } = cells.fitAreas(targets, { start: weights }));
    onProgress?.(round / rounds);
  }
}

/** A ring around a point, and the hole of it. */
const ellipse = (x, y, rx, ry) =>
  Array.from({ length: 180 }, (_, k) => {
    const angle = (2 * Math.PI * k) / 180;
    return [x + rx * Math.cos(angle), y + ry * Math.sin(angle)];
  });
const region = [ellipse(460, 240, 450, 230), ellipse(560, 240, 130, 66)];

export default async function relaxation(container) {
  const isIn = ({ x, y }) =>
    Math.hypot((x - 460) / 450, (y - 240) / 230) < 0.98 &&
    Math.hypot((x - 560) / 130, (y - 240) / 66) > 1.05;
  const places = randomCircles(700, width, height, 0, 0, 3).filter(isIn);
  const diagram = Diagram.from(places);
  const targets = places.map((_, id) => (id % 9 === 0 ? 8 : 1));
  const cells = diagram.voronoi(region);

  const canvas = container.appendChild(
    Object.assign(document.createElement("canvas"), { width, height }),
  );
  const bar = container.appendChild(
    Object.assign(document.createElement("progress"), { value: 0, ariaLabel: "Rounds" }),
  );
  const stop = container.appendChild(
    Object.assign(document.createElement("button"), { type: "button", textContent: "Stop" }),
  );
  const context = canvas.getContext("2d");
  const draw = () => {
    context.clearRect(0, 0, width, height);
    context.strokeStyle = "#fff";
    cells.renderCells(context, (id) => {
      context.fillStyle = targets[id] > 1 ? "#f28e2b" : "#4e79a7";
      context.fill();
      context.stroke();
    });
  };
  const controller = new AbortController();
  stop.onclick = () => controller.abort();
  const done = relax(diagram, region, targets, {
    rounds,
    signal: controller.signal,
    onProgress(share) {
      bar.value = share;
      draw();
    },
  })
    .catch((error) => {
      if (error.name !== "AbortError") throw error;
    })
    .finally(() => stop.remove());
  return { diagram, cells, targets, done, simulation: { stop: () => controller.abort() } };
}
