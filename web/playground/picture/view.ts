// The view transform between the diagram's coordinates (y upwards) and CSS pixels (y downwards):
// one scale, no rotation.
import type { Bounds } from "../model/circle.js";

const kSmallestScale = 1e-7;
const kLargestScale = 1e9;

/** In CSS pixels. */
export type Box = { left: number; top: number; right: number; bottom: number };

export class View {
  /** Size of the window in CSS pixels. */
  width = 1;
  height = 1;
  /** CSS pixels per unit of the diagram. */
  scale = 1;
  /** Where the diagram's origin is, in CSS pixels. */
  originX = 0;
  originY = 0;

  toScreenX(x: number): number {
    return x * this.scale + this.originX;
  }

  toScreenY(y: number) {
    return this.originY - y * this.scale;
  }

  toWorldX(x: number) {
    return (x - this.originX) / this.scale;
  }

  toWorldY(y: number) {
    return (this.originY - y) / this.scale;
  }

  /** Decimal places of numbers that are at most this many pixels apart. */
  digits(pixels: number) {
    return -Math.floor(Math.log10(pixels / this.scale));
  }

  /** The centre of the window and half its diagonal, in the diagram's units. */
  disc() {
    return {
      x: this.toWorldX(this.width / 2),
      y: this.toWorldY(this.height / 2),
      radius: Math.hypot(this.width, this.height) / 2 / this.scale,
    };
  }

  resize(width: number, height: number) {
    // The middle of the window stays where it is.
    this.originX += (width - this.width) / 2;
    this.originY += (height - this.height) / 2;
    this.width = width;
    this.height = height;
  }

  pan(dx: number, dy: number) {
    this.originX += dx;
    this.originY += dy;
  }

  /** Zooms by a factor; the point under (x, y) stays where it is. */
  zoom(factor: number, x: number, y: number) {
    const scale = Math.max(kSmallestScale, Math.min(kLargestScale, this.scale * factor));
    const f = scale / this.scale;
    this.originX = x + (this.originX - x) * f;
    this.originY = y + (this.originY - y) * f;
    this.scale = scale;
  }

  /**
   * Shows all of [xmin, ymin, xmax, ymax] with a margin, inside the window minus the insets
   * (pixels).
   */
  fit(
    [xmin, ymin, xmax, ymax]: Bounds,
    insets = { left: 0, top: 0, right: 0, bottom: 0 },
    margin = 28,
  ) {
    const width = Math.max(80, this.width - insets.left - insets.right - 2 * margin);
    const height = Math.max(80, this.height - insets.top - insets.bottom - 2 * margin);
    const scale = Math.min(
      width / Math.max(xmax - xmin, 1e-9),
      height / Math.max(ymax - ymin, 1e-9),
    );
    this.scale = Math.max(kSmallestScale, Math.min(kLargestScale, scale));
    this.originX = insets.left + margin + width / 2 - ((xmin + xmax) / 2) * this.scale;
    this.originY = insets.top + margin + height / 2 + ((ymin + ymax) / 2) * this.scale;
  }

  /** A copy to remember what was drawn. */
  copy() {
    return Object.assign(new View(), this);
  }
}
