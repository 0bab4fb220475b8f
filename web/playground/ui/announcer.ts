// Announcements for screen readers: what is selected, where it was moved or how large it was made,
// and which tool is chosen. It hears where a movement ended, not every step.
import type { App } from "../app.js";
import { whenever } from "../model/signals.js";
import { toolOf } from "../tools/registry.js";
import { grouped, neighboursText, setText, short } from "./dom.js";
import { element } from "./elements.js";

const kRest = 400; // ms

export function makeAnnouncer(app: App) {
  let announcing = 0;
  /** The selected circles, x, y, r of each, as they were told last. */
  let told = { ids: [] as readonly number[], xyr: new Float64Array(0) };

  const announce = (say: () => string) => {
    clearTimeout(announcing);
    announcing = setTimeout(() => {
      const text = say();
      if (text !== "") setText(element("announcer"), text);
      const ids = app.selection.ids;
      told = { ids, xyr: app.sites.triples(ids) };
    }, kRest);
  };

  let isNew = false; // the selection, not told yet
  const say = () => {
    const text = isNew ? selectionText(app) : changeText(app, told.xyr);
    isNew = false;
    return text;
  };
  whenever(
    () => app.selection.ids,
    () => {
      isNew = true;
      announce(say);
    },
  );
  app.model.on("change", () => app.selection.size > 0 && announce(say));
  let tool = app.tool;
  whenever(
    () => app.tool,
    () => {
      if (app.tool === tool) return;
      tool = app.tool;
      announce(() => `${toolOf(tool).label} tool`);
    },
  );
}

function selectionText({ selection, sites, diagram }: App) {
  if (selection.size === 0) return "Nothing selected";
  if (selection.size > 1) return `${grouped(selection.size)} circles selected`;
  const id = selection.single;
  const state = diagram.isHidden(id)
    ? `hidden inside ${sites.label(diagram.coverOf(id)).name}`
    : neighboursText(sites, id);
  return `${sites.label(id).name} selected, ${state}`;
}

/** Describes the change of the selected circles; "" if there is none. */
function changeText({ selection, sites }: App, before: Float64Array) {
  const { ids } = selection;
  const after = sites.triples(ids);
  if (before.length !== after.length) return "";
  const differs = (axes: number[]) =>
    ids.some((_, k) => axes.some((axis) => after[3 * k + axis] !== before[3 * k + axis]));
  const [isMoved, isResized] = [differs([0, 1]), differs([2])];
  if (!isMoved && !isResized) return "";
  const { name } = sites.label(selection.last);
  const who = ids.length > 1 ? `${grouped(ids.length)} circles` : name;
  const [x, y, r] = after;
  const where = ids.length > 1 ? "" : ` to x ${short(x)}, y ${short(y)}`;
  const size = ids.length > 1 ? "" : `, radius ${short(r)}`;
  return isMoved ? `${who} moved${where}` : `${who} resized${size}`;
}
