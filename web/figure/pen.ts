// A pen is what figures draw with. Its calls draw on a canvas in the browser (canvas_pen.ts) and
// write SVG where the site is built (svg_pen.ts), so that a page has its first picture before any
// script.
import type { ThemeName } from "../shared/theme.js";

type Look = { fill?: ThemeName; stroke?: ThemeName; width?: number; dash?: readonly number[] };

/** All looks of all figures: one meaning, one look, on each page. Widths are in CSS pixels. */
export const kLooks = {
  circle: { fill: "siteFill", stroke: "site", width: 1.5 },
  rim: { stroke: "site", width: 1.5 },
  hidden: { fill: "hiddenFill", stroke: "hidden", width: 1.5, dash: [4, 3] },
  hiddenSolid: { fill: "hiddenFill", stroke: "hidden", width: 1 },
  hiddenLine: { stroke: "hidden", width: 2 },
  hiddenDot: { fill: "hidden" },
  treeEdge: { stroke: "cell", width: 1.5 },
  nearest: { fill: "accentFill", stroke: "accent", width: 2.5 },
  nearestCell: { fill: "accentSite" },
  neighbor: { fill: "neighborFill", stroke: "neighbor", width: 2.5 },
  wrong: { fill: "wrongFill", stroke: "wrong", width: 2.5 },
  wrongArea: { fill: "wrongFill" },
  ok: { fill: "ok" },
  alarm: { fill: "wrong" },
  off: { fill: "line" },
  edge: { stroke: "cell", width: 1.25 },
  strongEdge: { stroke: "ink", width: 2.25 },
  quietEdge: { stroke: "distance", width: 1 },
  centreEdge: { stroke: "centres", width: 1.5, dash: [5, 4] },
  centre: { fill: "ink" },
  dual: { stroke: "dual", width: 1.5 },
  conflict: { stroke: "wrong", width: 3 },
  fresh: { stroke: "dual", width: 3 },
  partEdge: { stroke: "dual", width: 1.25, dash: [4, 4] },
  firstEdge: { stroke: "site", width: 3 },
  secondEdge: { stroke: "vertex", width: 3 },
  added: { fill: "emptyFill", stroke: "dual", width: 2.5 },
  empty: { fill: "emptyFill", stroke: "vertex", width: 1.5 },
  vertex: { fill: "vertex" },
  frame: { stroke: "line", width: 1 },
  window: { fill: "land", stroke: "coast", width: 1.5 },
  sea: { fill: "sea", stroke: "coast", width: 1.5 },
  land: { fill: "land" },
  paper: { fill: "paper" },
  ruler: { stroke: "accent", width: 2.5 },
  reach: { stroke: "accent", width: 1.5, dash: [5, 4] },
  otherRuler: { stroke: "selected", width: 2.5 },
  pointer: { stroke: "ink", width: 2 },
  name: { fill: "ink" },
  quiet: { fill: "quiet" },
  bar: { fill: "site" },
  otherBar: { fill: "centres" },
  thirdBar: { fill: "vertex" },
  firstArea: { fill: "siteFill" },
  secondArea: { fill: "hiddenFill" },
  thirdArea: { fill: "emptyFill" },
  fourthArea: { fill: "land" },
} satisfies Record<string, Look>;

export type LookName = keyof typeof kLooks;
export const lookOf = (name: LookName): Look => kLooks[name];

export type Align = "start" | "middle" | "end";

/** Lengths and coordinates are in units of the figure, y downwards. */
export interface Pen {
  readonly width: number;
  readonly height: number;
  /** CSS pixels of a unit. */
  readonly scale: number;
  circle(x: number, y: number, r: number, look: LookName): void;
  /** `data` as in the `d` of an SVG path: what `render()` of the package gives. */
  path(data: string, look: LookName): void;
  line(x0: number, y0: number, x1: number, y1: number, look: LookName): void;
  rectangle(x: number, y: number, width: number, height: number, look: LookName): void;
  /** `size` in CSS pixels, so that text can be read on a phone too. */
  text(text: string, x: number, y: number, look: LookName, options?: TextOptions): void;
  /** Moves the drawing of `draw` by x, y and cuts it at the rectangle of this size there. */
  inside(x: number, y: number, width: number, height: number, draw: () => void): void;
  /** A colour of theme.css as red, green, blue, each from 0 to 255, for `pixels`. */
  tone(name: ThemeName): readonly [number, number, number];
  /** A picture of pixels in a rectangle: red, green, blue, opacity of each. Nothing in an SVG. */
  pixels(x: number, y: number, width: number, height: number, pixels: Pixels): void;
}

export type TextOptions = { align?: Align; size?: number; isBold?: boolean };
export type Pixels = { columns: number; rows: number; bytes: Uint8ClampedArray<ArrayBuffer> };

/** A cross at the pointer. */
export function drawPointer(pen: Pen, x: number, y: number) {
  const arm = 8 / pen.scale;
  pen.line(x - arm, y, x + arm, y, "pointer");
  pen.line(x, y - arm, x, y + arm, "pointer");
}

/** A dot that looks as large at each scale; `size` is its radius in CSS pixels. */
export const drawDot = (pen: Pen, x: number, y: number, look: LookName, size = 3) =>
  pen.circle(x, y, size / pen.scale, look);
