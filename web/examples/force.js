// d3-force moves circles, and the diagram follows: one updateMany a tick. Lines join neighbours
// whose rims are close.
import { Diagram } from "apollonius-diagram";
import { forceCollide, forceSimulation, forceX, forceY } from "d3-force";
import { randomCircles } from "./random_circles.js";

const width = 920,
  height = 480,
  close = 12;

export default function force(container) {
  const nodes = randomCircles(400, width, height, 2, 22);
  const diagram = Diagram.from(nodes);
  const ids = diagram.ids();
  const xyr = new Float64Array(3 * nodes.length);

  const canvas = container.appendChild(
    Object.assign(document.createElement("canvas"), { width, height }),
  );
  const context = canvas.getContext("2d");
  let mouse = null;
  let lit = -1; // the circle that is drawn as the one pointed at
  canvas.onpointerdown = canvas.onpointermove = ({ offsetX, offsetY }) => {
    // The canvas may be shown smaller than it is.
    mouse = [(offsetX * width) / canvas.clientWidth, (offsetY * height) / canvas.clientHeight];
    draw(); // the simulation may be at rest
  };

  const simulation = forceSimulation(nodes)
    .force("x", forceX(width / 2).strength(0.03))
    .force("y", forceY(height / 2).strength(0.08))
    .force(
      "collide",
      forceCollide((node) => node.r + 2),
    )
    .alphaDecay(0.01)
    .on("tick", () => {
      nodes.forEach(({ x, y, r }, id) => xyr.set([x, y, r], 3 * id));
      diagram.updateMany(ids, xyr);
      draw();
    });

  function draw() {
    context.clearRect(0, 0, width, height);
    context.strokeStyle = "#bbb";
    context.beginPath();
    const { sites } = diagram.edges();
    for (let k = 0; k < sites.length; k += 2) {
      const [a, b] = [nodes[sites[k]], nodes[sites[k + 1]]];
      if (Math.hypot(a.x - b.x, a.y - b.y) - a.r - b.r > close) continue;
      context.moveTo(a.x, a.y);
      context.lineTo(b.x, b.y);
    }
    context.stroke();
    lit = mouse ? diagram.find(mouse[0], mouse[1]) : -1;
    const around = new Set(lit < 0 ? [] : diagram.neighbors(lit));
    nodes.forEach(({ x, y, r }, id) => {
      context.fillStyle = id === lit ? "#e15759" : around.has(id) ? "#f28e2b" : "#4e79a7";
      context.beginPath();
      context.arc(x, y, r, 0, 2 * Math.PI);
      context.fill();
      context.strokeStyle = "#fff";
      context.stroke();
    });
  }
  draw(); // before the first tick
  return { diagram, nodes, simulation, lit: () => lit };
}
