// What a step shows as open: the cell of a site that comes or goes, empty.
import type { Picture } from "../picture/painter.js";

/** Fills and outlines what `addBoundary` adds to the context's path. */
export function drawHole(
  context: CanvasRenderingContext2D,
  { theme }: Picture,
  addBoundary: () => void,
) {
  context.beginPath();
  addBoundary();
  context.fillStyle = theme.paper;
  context.fill();
  context.strokeStyle = theme.selected;
  context.lineWidth = 2;
  context.stroke();
}
