// Runs in a worker: builds a diagram from circles, then answers arrays of points with arrays of ids
// and distances.
import { Diagram } from "apollonius-diagram";

let diagram;
self.onmessage = ({ data: { circles, points, question } }) => {
  if (circles) diagram = new Diagram(circles);
  if (!points) return;
  const distances = new Float64Array(points.length / 2);
  const ids = diagram.findMany(points, distances);
  const transfer = [ids.buffer, distances.buffer]; // moved, not copied
  self.postMessage({ ids, distances, question }, { transfer });
};
