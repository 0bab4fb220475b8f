// The drawing context of a canvas, which a browser may refuse.

export function contextOf(canvas: HTMLCanvasElement): CanvasRenderingContext2D;
export function contextOf(canvas: OffscreenCanvas): OffscreenCanvasRenderingContext2D;
export function contextOf(canvas: HTMLCanvasElement | OffscreenCanvas) {
  const context = canvas.getContext("2d");
  if (!context) throw new Error("this browser has no more memory for drawings");
  return context;
}
