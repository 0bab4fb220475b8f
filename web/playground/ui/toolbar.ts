// The bar of tools: a button for each that is registered, and those that do something at once.
import { make, makeSvg } from "../../shared/dom.js";
import type { App } from "../app.js";
import { effect } from "../model/signals.js";
import { kTools } from "../tools/registry.js";
import type { Tool } from "../tools/tool.js";
import { element } from "./elements.js";

const kZoom = 1.5;

export function makeToolbar(app: App) {
  const buttons = new Map(kTools.map((tool) => [tool, buttonOf(tool)]));
  element("tools").prepend(...buttons.values());
  for (const [tool, button] of buttons)
    button.addEventListener("click", () => {
      if (!tool.press?.(app)) app.tool = tool.id;
    });
  effect(() => {
    for (const [tool, button] of buttons)
      button.setAttribute("aria-pressed", String(app.tool === tool.id));
  });
  effect(() => {
    element("tool-undo").disabled = !app.model.canUndo;
    element("tool-redo").disabled = !app.model.canRedo;
  });
  element("tool-undo").addEventListener("click", () => app.edits.undo());
  element("tool-redo").addEventListener("click", () => app.edits.redo());
  element("tool-out").addEventListener("click", () => app.camera.zoom(1 / kZoom));
  element("tool-in").addEventListener("click", () => app.camera.zoom(kZoom));
  element("tool-fit").addEventListener("click", () => app.camera.fit());
}

function buttonOf({ id, key, label, icon }: Tool) {
  const letter = key.toUpperCase();
  const shapes = icon.map(([kind, attributes]) => makeSvg(kind, attributes));
  const button = make(
    "button",
    { type: "button", id: `tool-${id}` },
    makeSvg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, ...shapes),
    make("span", {}, label),
    make("kbd", { ariaHidden: "true" }, letter),
  );
  button.setAttribute("aria-keyshortcuts", letter);
  return button;
}
