// Why not a plain Voronoi diagram? Left, the cells of the centres (d3-delaunay); right, the cells
// of the circles. A cross marks the pointer; what it picks is red.
import { Diagram } from "apollonius-diagram";
import { Delaunay } from "d3-delaunay";
import { randomCircles } from "./random_circles.js";

const width = 450,
  height = 330,
  gap = 20;

export default function comparison(container) {
  const bubbles = randomCircles(16, width, height, 6, 105, 22);
  const delaunay = Delaunay.from(
    bubbles,
    (d) => d.x,
    (d) => d.y,
  );
  const diagram = Diagram.from(bubbles);
  const canvas = container.appendChild(
    Object.assign(document.createElement("canvas"), { width: 2 * width + gap, height }),
  );
  const context = canvas.getContext("2d");
  const sides = [
    { left: 0, find: (x, y) => delaunay.find(x, y) },
    { left: width + gap, find: (x, y) => diagram.find(x, y) },
  ].map(({ left, find }) => ({ left, find, cells: cellsOf(find) }));

  function cellsOf(find) {
    const image = context.createImageData(width, height);
    const owner = Array.from({ length: width * height }, (_, k) =>
      find(k % width, Math.floor(k / width)),
    );
    owner.forEach((id, k) => {
      const isEdge = id !== owner[k - 1] || id !== owner[k - width];
      const light = isEdge ? 0.55 : 1;
      image.data.set(
        [
          (205 + ((id * 37) % 45)) * light,
          (205 + ((id * 61) % 45)) * light,
          (205 + ((id * 17) % 45)) * light,
          255,
        ],
        4 * k,
      );
    });
    return image;
  }

  function draw(x, y) {
    context.clearRect(0, 0, canvas.width, height);
    for (const { left, find, cells } of sides) {
      const picked = find(x, y);
      context.save();
      context.putImageData(cells, left, 0);
      context.beginPath();
      context.rect(left, 0, width, height);
      context.clip();
      context.translate(left, 0);
      bubbles.forEach((bubble, id) => {
        context.beginPath();
        context.arc(bubble.x, bubble.y, bubble.r, 0, 2 * Math.PI);
        context.fillStyle = id === picked ? "#e1575999" : "#4e79a755";
        context.strokeStyle = id === picked ? "#c0272d" : "#4e79a7";
        context.fill();
        context.stroke();
      });
      context.strokeStyle = "#111";
      context.lineWidth = 2;
      context.beginPath();
      for (const [dx, dy] of [
        [8, 8],
        [8, -8],
      ]) {
        context.moveTo(x - dx, y - dy);
        context.lineTo(x + dx, y + dy);
      }
      context.stroke();
      context.restore();
    }
    return sides.map(({ find }) => find(x, y));
  }
  canvas.onpointerdown = canvas.onpointermove = ({ offsetX, offsetY }) => {
    // The canvas may be shown smaller than it is.
    const x = (offsetX * canvas.width) / canvas.clientWidth;
    const y = (offsetY * canvas.height) / canvas.clientHeight;
    draw(x % (width + gap), y);
  };
  // To begin with, where the plain diagram errs most: deep inside one circle, and another one
  // picked.
  const error = (x, y) => {
    const distance = (id) => Math.hypot(bubbles[id].x - x, bubbles[id].y - y) - bubbles[id].r;
    return (
      distance(delaunay.find(x, y)) -
      distance(diagram.find(x, y)) -
      2 * Math.max(0, distance(diagram.find(x, y)) + 8)
    );
  };
  let worst = [0, 0];
  for (let x = 5; x < width; x += 5) {
    for (let y = 5; y < height; y += 5) if (error(x, y) > error(...worst)) worst = [x, y];
  }
  const [plain, weighted] = draw(...worst);
  return { bubbles, plain, weighted, worst, sides, canvas };
}
