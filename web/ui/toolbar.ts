// The bar of tools.
import type { App } from "../app.js";
import { element } from "./elements.js";

const kTools = ["select", "draw", "pan", "delete"] as const;
const kZoom = 1.5;

export function makeToolbar(app: App) {
  const show = () => {
    for (const tool of kTools)
      element(`tool-${tool}`).setAttribute("aria-pressed", String(app.tool === tool));
    element("tool-undo").disabled = !app.model.history.canUndo;
    element("tool-redo").disabled = !app.model.history.canRedo;
  };
  for (const tool of kTools)
    element(`tool-${tool}`).addEventListener("click", () => {
      // With something selected, "Delete" is what it says.
      if (tool === "delete" && app.selection.size > 0) app.removeSelected();
      else app.tool = tool;
    });
  element("tool-undo").addEventListener("click", () => app.undo());
  element("tool-redo").addEventListener("click", () => app.redo());
  element("tool-out").addEventListener("click", () => app.zoom(1 / kZoom));
  element("tool-in").addEventListener("click", () => app.zoom(kZoom));
  element("tool-fit").addEventListener("click", () => app.fit());
  app.on("tool", show);
  app.on("history", show);
  show();
}
