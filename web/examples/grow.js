// Circles that grow until they meet, and stop where they have come far enough: cells cut at a
// distance. The slider says how far.
import { Diagram } from "apollonius-diagram";
import { randomCircles } from "./random_circles.js";

const width = 920,
  height = 480;

export default function grow(container) {
  const circles = randomCircles(70, width, height, 2, 34, 23);
  const diagram = Diagram.from(circles);
  const canvas = container.appendChild(
    Object.assign(document.createElement("canvas"), { width, height }),
  );
  const slider = container.appendChild(
    Object.assign(document.createElement("input"), {
      type: "range",
      min: 0,
      max: 80,
      value: 26,
      ariaLabel: "Distance",
    }),
  );
  const context = canvas.getContext("2d");

  /** The share of the picture that is within the distance of a circle. */
  const draw = () => {
    const cells = diagram.voronoi([0, 0, width, height], { maxDistance: Number(slider.value) });
    context.clearRect(0, 0, width, height);
    cells.renderCells(context, (id) => {
      context.fillStyle = ["#a0cbe8", "#ffbe7d", "#8cd17d", "#d4a6c8"][id % 4];
      context.fill();
    });
    context.lineWidth = 1;
    context.strokeStyle = "#333";
    context.beginPath();
    cells.render(context);
    context.stroke();
    context.fillStyle = "#333";
    context.beginPath();
    for (const { x, y, r } of circles) {
      context.moveTo(x + r, y);
      context.arc(x, y, r, 0, 2 * Math.PI);
    }
    context.fill();
    const covered = cells.cellAreas().reduce((sum, area) => sum + area, 0) / (width * height);
    cells.dispose();
    return covered;
  };
  let covered = draw();
  slider.addEventListener("input", () => {
    covered = draw();
  });
  return { circles, slider, covered: () => covered };
}
