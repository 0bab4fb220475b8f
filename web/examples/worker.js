// The nearest circle of every pixel, found in a worker in one call; the page stays free.
import { randomCircles } from "./random_circles.js";

const width = 460,
  height = 240;

export default async function worker(container) {
  // Import maps do not reach into workers, so this page hands the worker's code over with the
  // address filled in; with a bundler, new Worker(new URL("./nearest_worker.js", import.meta.url),
  // { type: "module" }) is all.
  const text = await (await fetch(new URL("./nearest_worker.js", import.meta.url))).text();
  const source = text.replace(
    '"apollonius-diagram"',
    JSON.stringify(import.meta.resolve("apollonius-diagram")),
  );
  const nearest = new Worker(URL.createObjectURL(new Blob([source], { type: "text/javascript" })), {
    type: "module",
  });

  const circles = Float64Array.from(
    randomCircles(60, width, height, 2, 40).flatMap(({ x, y, r }) => [x, y, r]),
  );
  const points = new Float64Array(2 * width * height);
  for (let k = 0; k < width * height; ++k)
    points.set([(k % width) + 0.5, Math.floor(k / width) + 0.5], 2 * k);
  const answer = new Promise((resolve) => (nearest.onmessage = ({ data }) => resolve(data)));
  nearest.postMessage({ circles, points }, [circles.buffer, points.buffer]);
  const { ids, distances } = await answer;

  const canvas = container.appendChild(
    Object.assign(document.createElement("canvas"), { width, height }),
  );
  const context = canvas.getContext("2d");
  const image = context.createImageData(width, height);
  ids.forEach((id, k) => {
    const shade = distances[k] <= 0 ? 0.6 : 1 - 0.3 * Number(distances[k] % 12 < 1);
    image.data.set(
      [90 + ((id * 67) % 150), 90 + ((id * 131) % 150), 90 + ((id * 29) % 150)]
        .map((c) => c * shade)
        .concat(255),
      4 * k,
    );
  });
  context.putImageData(image, 0, 0);
  return { ids, distances, width, height };
}
