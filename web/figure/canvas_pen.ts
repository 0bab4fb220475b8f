// Draws on a canvas.
import { bytesOf, contextOf } from "../shared/canvas.js";
import type { Theme, ThemeName } from "../shared/theme.js";
import {
  type Align,
  type LookName,
  lookOf,
  type Pen,
  type Pixels,
  type TextOptions,
} from "./pen.js";

const kAligns: Record<Align, CanvasTextAlign> = { start: "left", middle: "center", end: "right" };

export class CanvasPen implements Pen {
  /** @param scale CSS pixels of a unit; `density`: pixels of the screen in a CSS pixel */
  constructor(
    readonly context: CanvasRenderingContext2D,
    readonly width: number,
    readonly height: number,
    readonly scale: number,
    density: number,
    readonly theme: Theme,
  ) {
    context.setTransform(scale * density, 0, 0, scale * density, 0, 0);
    context.clearRect(0, 0, width, height);
    context.lineJoin = "round";
    context.lineCap = "round";
  }

  #paint(look: LookName, path: Path2D) {
    const { fill, stroke, width = 1, dash = [] } = lookOf(look);
    const { context, scale } = this;
    if (fill) {
      context.fillStyle = this.theme[fill];
      context.fill(path, "evenodd");
    }
    if (stroke) {
      context.strokeStyle = this.theme[stroke];
      context.lineWidth = width / scale;
      context.setLineDash(dash.map((length) => length / scale));
      context.stroke(path);
    }
  }

  circle(x: number, y: number, r: number, look: LookName) {
    const path = new Path2D();
    path.arc(x, y, Math.max(r, 0), 0, 2 * Math.PI);
    this.#paint(look, path);
  }

  path(data: string, look: LookName) {
    this.#paint(look, new Path2D(data));
  }

  line(x0: number, y0: number, x1: number, y1: number, look: LookName) {
    const path = new Path2D();
    path.moveTo(x0, y0);
    path.lineTo(x1, y1);
    this.#paint(look, path);
  }

  rectangle(x: number, y: number, width: number, height: number, look: LookName) {
    const path = new Path2D();
    path.rect(x, y, width, height);
    this.#paint(look, path);
  }

  text(text: string, x: number, y: number, look: LookName, options: TextOptions = {}) {
    const { align = "start", size = 14, isBold = false } = options;
    const { context } = this;
    context.font = `${isBold ? 600 : 400} ${size / this.scale}px ${this.theme.sans}`;
    context.textAlign = kAligns[align];
    context.textBaseline = "middle";
    context.lineWidth = 4 / this.scale;
    context.setLineDash([]);
    context.strokeStyle = this.theme.paper; // so that it can be read on lines
    context.strokeText(text, x, y);
    context.fillStyle = this.theme[lookOf(look).fill ?? "ink"];
    context.fillText(text, x, y);
  }

  inside(x: number, y: number, width: number, height: number, draw: () => void) {
    const { context } = this;
    context.save();
    context.translate(x, y);
    context.beginPath();
    context.rect(0, 0, width, height);
    context.clip();
    draw();
    context.restore();
  }

  tone(name: ThemeName): [number, number, number] {
    const [red, green, blue] = bytesOf(this.theme[name]);
    return [red, green, blue];
  }

  pixels(x: number, y: number, width: number, height: number, { columns, rows, bytes }: Pixels) {
    const canvas = new OffscreenCanvas(columns, rows);
    contextOf(canvas).putImageData(new ImageData(bytes, columns, rows), 0, 0);
    this.context.drawImage(canvas, x, y, width, height);
  }
}
