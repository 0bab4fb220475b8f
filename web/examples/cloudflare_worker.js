// Cloudflare Workers: nothing to set up. wrangler takes the package's condition `workerd`, whose
// entry imports the compiled module; the diagram is made once and serves all requests.
import { Diagram } from "apollonius-diagram";

const bubbles = [
  { x: 100, y: 80, r: 50 },
  { x: 190, y: 90, r: 15 },
  { x: 105, y: 90, r: 10 },
];
let diagram;

export default {
  /** /?x=155&y=88: the nearest bubble. */
  fetch(request) {
    const { searchParams } = new URL(request.url);
    diagram ??= Diagram.from(bubbles);
    const nearest = diagram.nearest(Number(searchParams.get("x")), Number(searchParams.get("y")));
    return Response.json(nearest);
  },
};
