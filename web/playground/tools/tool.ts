// A tool of the playground. A new one is a file that describes it, and a line in registry.ts: its
// button, its key and its part of the help are made from that.
import type { App } from "../app.js";

export type PointerKind = "mouse" | "pen" | "touch";
/** Where the pointer is, in pixels. */
export type Touch = {
  x: number;
  y: number;
  type: PointerKind;
  shiftKey: boolean;
  altKey: boolean;
  time: number;
};
/** `move` comes once the pointer has left where it went down; `hold` if it stays there. */
export type Gesture = {
  cursor: string;
  move(at: Touch): void;
  end(at: Touch): void;
  cancel(): void;
  hold?(at: Touch): void;
};

/** An element of SVG, and its attributes. */
export type Shape = readonly ["path" | "circle", Readonly<Record<string, string>>];

export type Tool = {
  id: string;
  /** The key that chooses it: a small letter. */
  key: string;
  label: string;
  /** The button's picture, 24 by 24. */
  icon: readonly Shape[];
  /** Sentences on its gestures, by mouse or pen and by touch; *what is done* between asterisks. */
  help?: { fine?: readonly string[]; coarse?: readonly string[] };
  /** While nothing is under way. */
  cursor(app: App, at: Touch): string;
  /** Begins a gesture when the pointer goes down. */
  gesture(app: App, at: Touch): Gesture;
  /** The pointer moves, and nothing is under way. */
  hover?(app: App, at: Touch): void;
  doubleClick?(app: App, x: number, y: number): void;
  /** Its button is pressed: whether that has done something, and the tool is not chosen. */
  press?(app: App): boolean;
  /** Does the same with Alt; with others the Draw tool's gesture begins then. */
  ignoresAlt?: boolean;
};

/** Pixels around a point or a small circle that count as hit. */
export const kReach: Record<PointerKind, number> = { mouse: 5, pen: 8, touch: 16 };
