// The drawing context of a canvas, which a browser may refuse, and what a colour is in it.

export function contextOf(canvas: HTMLCanvasElement): CanvasRenderingContext2D;
export function contextOf(canvas: OffscreenCanvas): OffscreenCanvasRenderingContext2D;
export function contextOf(canvas: HTMLCanvasElement | OffscreenCanvas) {
  const context = canvas.getContext("2d");
  if (!context) throw new Error("this browser has no more memory for drawings");
  return context;
}

/** Red, green, blue and opacity, each from 0 to 255. */
export function bytesOf(color: string) {
  const context = contextOf(new OffscreenCanvas(1, 1));
  context.fillStyle = color;
  context.fillRect(0, 0, 1, 1);
  return context.getImageData(0, 0, 1, 1).data;
}
