// Runs in a worker: builds a diagram from circles, then answers arrays of points with arrays of ids
// and distances.
import { Diagram } from "apollonius-diagram";

let diagram;
self.onmessage = ({ data: { circles, points, question } }) => {
  if (circles) diagram = new Diagram(circles);
  if (!points) return;
  const { ids, distances } = diagram.nearestMany(points);
  const transfer = [ids.buffer, distances.buffer]; // moved, not copied
  self.postMessage({ ids, distances, question }, { transfer });
};
