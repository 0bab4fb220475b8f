// A figure is a state, how it is drawn, what is said of it, and what a reader can do. Nothing here
// needs a browser, so that the first picture can be drawn where the site is built; runner.ts lets
// it live on a page.
import type { Part } from "../shared/package.js";
import type { LookName, Pen } from "./pen.js";

export type Point = readonly [x: number, y: number];
export type Size = readonly [width: number, height: number];

/** Text about a figure: plain, or in the colour of what it speaks of. */
export type Said = string | readonly [text: string, color: SaidColor];
export type SaidColor = "nearest" | "wrong" | "neighbor" | "hidden" | "edge" | "dual" | "vertex";

/** Where readers can take hold of something. With the keyboard, arrows move it. */
export type Handle = {
  /** The figure's name, for those who do not see it. */
  label: string;
  x: number;
  y: number;
  /** It can be taken anywhere in a circle of this radius; without it, near the point. */
  r?: number;
  move(x: number, y: number): void;
};

export type Control<State> = {
  /** Whether it has a use now; without it, always. */
  isShown?(state: State): boolean;
} & (
  | {
      kind: "slider";
      label: string;
      min: number;
      max: number;
      step: number;
      get(state: State): number;
      set(state: State, value: number): void;
      /** The value as it is shown beside the slider; "" for none. */
      show?(state: State): string;
    }
  | {
      kind: "choice";
      label: string;
      options: readonly (readonly [value: string, label: string])[];
      get(state: State): string;
      set(state: State, value: string): void;
    }
  | {
      kind: "switch";
      label: string;
      get(state: State): boolean;
      set(state: State, isOn: boolean): void;
    }
  | {
      kind: "button";
      /** A text, or what it is now. */
      label: string | ((state: State) => string);
      act(state: State): void | Promise<void>;
      isDisabled?(state: State): boolean;
    }
);

export type Figure<State> = {
  /** Parts of the package that it needs beside diagrams and queries; without it, shapes. */
  needs?: readonly Part[];
  /** In units, which are CSS pixels where there is room; `narrow` below 520 pixels. */
  size: { wide: Size; narrow: Size };
  /** A new state, for a drawing of this size; Reset asks for another one. */
  start(size: Size, isNarrow: boolean): State;
  draw(pen: Pen, state: State): void;
  /** Says in a sentence or two what the picture shows; read aloud when it changes. */
  say(state: State): readonly Said[];
  controls?: readonly Control<State>[];
  handles?(state: State): readonly Handle[];
  /** The pointer is at a point, or has left. With the keyboard, arrows move it. */
  hover?(state: State, at: Point | null): void;
  /** A click, a tap, or Enter at the pointer. */
  press?(state: State, at: Point): void;
  /**
   * The picture is dragged by the mouse or a finger; arrow keys move the view instead of the
   * pointer. Fingers drag sideways only: up and down scrolls the page.
   */
  drag?(state: State, dx: number, dy: number): void;
  /** The call of the package that the picture shows, with its numbers, as a line of a program. */
  code?(state: State): string;
  /**
   * Moves on by itself; false: nothing will move until something is done. What the reader has not
   * asked for ends after ten seconds.
   * @param isReduced the reader wants no motion: what moves does so only if it was asked for
   */
  tick?(state: State, seconds: number, isReduced: boolean): boolean;
  /**
   * For a figure in a `div.steps`, beside paragraphs with `data-step`: the one that is being read
   * sets the step, and the step marks its paragraph.
   */
  steps?: { get(state: State): number; set(state: State, step: number): void };
  /** The circles as they are, x, y, r of each, for the playground. */
  circles?(state: State): ArrayLike<number>;
};

/** A figure with whatever state. */
// biome-ignore lint/suspicious/noExplicitAny: the state is the figure's own
export type AnyFigure = Figure<any>;

/** So that a module's figure has its types. */
export const figure = <State>(made: Figure<State>): Figure<State> => made;

/** Looks that go with the colours of texts. */
export const kSaidLooks: Record<SaidColor, LookName> = {
  nearest: "nearest",
  wrong: "wrong",
  neighbor: "neighbor",
  hidden: "hidden",
  edge: "edge",
  dual: "dual",
  vertex: "empty",
};
