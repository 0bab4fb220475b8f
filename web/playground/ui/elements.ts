// The ids of index.html that the page's code asks for, each with what it is.

const kElements = {
  "open-code": HTMLButtonElement,
  map: HTMLCanvasElement,
  lines: HTMLCanvasElement,
  spare: HTMLCanvasElement,
  circles: HTMLCanvasElement,
  overlay: HTMLCanvasElement,
  tag: HTMLElement,
  intro: HTMLElement,
  about: HTMLElement,
  invitation: HTMLElement,
  sheet: HTMLElement,
  grip: HTMLButtonElement,
  answer: HTMLElement,
  inspector: HTMLElement,
  "card-name": HTMLElement,
  "card-close": HTMLButtonElement,
  "card-detail": HTMLElement,
  "card-numbers": HTMLElement,
  "card-x": HTMLInputElement,
  "card-y": HTMLInputElement,
  "card-r": HTMLInputElement,
  "card-facts": HTMLElement,
  "card-smaller": HTMLButtonElement,
  "card-larger": HTMLButtonElement,
  "card-duplicate": HTMLButtonElement,
  "card-delete": HTMLButtonElement,
  status: HTMLElement,
  "count-all": HTMLElement,
  "of-hidden": HTMLElement,
  "count-hidden": HTMLElement,
  timing: HTMLElement,
  credit: HTMLElement,
  library: HTMLElement,
  install: HTMLButtonElement,
  "open-code-2": HTMLButtonElement,
  tools: HTMLElement,
  "tool-undo": HTMLButtonElement,
  "tool-redo": HTMLButtonElement,
  "tool-out": HTMLButtonElement,
  "tool-fit": HTMLButtonElement,
  "tool-in": HTMLButtonElement,
  sets: HTMLElement,
  presets: HTMLElement,
  random: HTMLFormElement,
  paste: HTMLTextAreaElement,
  "load-text": HTMLButtonElement,
  "load-file": HTMLButtonElement,
  file: HTMLInputElement,
  clear: HTMLButtonElement,
  show: HTMLElement,
  layers: HTMLFieldSetElement,
  "layer-map": HTMLElement,
  "layer-coast": HTMLElement,
  questions: HTMLFieldSetElement,
  "nearest-count": HTMLInputElement,
  drift: HTMLButtonElement,
  "help-fine": HTMLElement,
  "help-coarse": HTMLElement,
  "open-code-3": HTMLButtonElement,
  share: HTMLElement,
  "copy-link": HTMLButtonElement,
  "link-note": HTMLElement,
  exports: HTMLElement,
  code: HTMLDialogElement,
  "code-close": HTMLButtonElement,
  "code-text": HTMLElement,
  "code-copy": HTMLButtonElement,
  progress: HTMLElement,
  "progress-text": HTMLElement,
  "progress-bar": HTMLProgressElement,
  "progress-cancel": HTMLButtonElement,
  "stop-motion": HTMLButtonElement,
  notice: HTMLElement,
  drop: HTMLElement,
  announcer: HTMLElement,
} satisfies Record<string, new () => HTMLElement>;

type Elements = typeof kElements;
export type ElementId = keyof Elements;

/** The element of the page that has this id. Throws if there is none, or one of another kind. */
export function element<Id extends ElementId>(id: Id): InstanceType<Elements[Id]>;
export function element(id: ElementId): HTMLElement {
  const found = document.getElementById(id);
  const kind = kElements[id];
  if (!(found instanceof kind)) throw new Error(`the page has no ${kind.name} with the id ${id}`);
  return found;
}

/** All of them: for a test. */
export const kElementIds = Object.keys(kElements) as ElementId[];
