// The bar of tools: a button for each that is registered, and those that do something at once.
import type { App } from "../app.js";
import { effect } from "../model/signals.js";
import { kTools } from "../tools/registry.js";
import type { Tool } from "../tools/tool.js";
import { element } from "./elements.js";

const kZoom = 1.5;
const kSvg = "http://www.w3.org/2000/svg";

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
  element("tool-undo").addEventListener("click", () => app.undo());
  element("tool-redo").addEventListener("click", () => app.redo());
  element("tool-out").addEventListener("click", () => app.zoom(1 / kZoom));
  element("tool-in").addEventListener("click", () => app.zoom(kZoom));
  element("tool-fit").addEventListener("click", () => app.fit());
}

function buttonOf({ id, key, label, icon }: Tool) {
  const name = Object.assign(document.createElement("span"), { textContent: label });
  const shortcut = Object.assign(document.createElement("kbd"), { textContent: key.toUpperCase() });
  shortcut.setAttribute("aria-hidden", "true");
  const button = Object.assign(document.createElement("button"), {
    type: "button",
    id: `tool-${id}`,
  });
  button.setAttribute("aria-keyshortcuts", key.toUpperCase());
  button.append(pictureOf(icon), name, shortcut);
  return button;
}

function pictureOf(icon: Tool["icon"]) {
  const svg = document.createElementNS(kSvg, "svg");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("aria-hidden", "true");
  for (const [kind, attributes] of icon) {
    const shape = document.createElementNS(kSvg, kind);
    for (const [name, value] of Object.entries(attributes)) shape.setAttribute(name, value);
    svg.append(shape);
  }
  return svg;
}
