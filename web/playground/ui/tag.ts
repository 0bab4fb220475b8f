// The tag at the pointer: which site is nearest, how far it is, and what else was asked. On a phone
// the sheet says it; of a selected circle the sheet says what the card is about.
import { make } from "../../shared/dom.js";
import type { App } from "../app.js";
import { whenever } from "../model/signals.js";
import type { Sites } from "../model/sites.js";
import type { Point } from "../pointer.js";
import type { Hover } from "../picture/overlay_layer.js";
import type { View } from "../picture/view.js";
import { type Globe, placeOn } from "../model/globe.js";
import { away, grouped, neighboursText, oncePerFrame, short } from "./dom.js";
import { element } from "./elements.js";

const kGap = 16; // pixels between pointer and tag
const kMostNames = 4;

export function makeTag(app: App) {
  const tag = element("tag");
  const answer = element("answer");

  const update = oncePerFrame(() => {
    const { hover } = app.pointer;
    tag.hidden = hover === null;
    const said = hover ? textOf(app, hover) : null;
    if (hover && said) {
      write(tag, said);
      place(tag, hover, app.view);
    }
    write(answer, selectedText(app) ?? said ?? ["", promptOf(app)]);
  });
  whenever(() => [app.pointer.hover, app.selection.ids], update);
  app.model.on("change", update);
  update();
}

const promptOf = ({ sites }: App) => (sites.size === 0 ? "Draw a circle" : "Touch the diagram");

function write(node: HTMLElement, [name, detail]: [string, string]) {
  const [strong, rest] = partsOf(node);
  strong.textContent = name;
  rest.textContent = name === "" ? detail : ` ${detail}`;
}

/** Names what is selected; null if nothing is. */
function selectedText({ selection, sites, diagram }: App): [string, string] | null {
  if (selection.size === 0) return null;
  const id = selection.single;
  if (id < 0) return [`${grouped(selection.size)} circles`, "selected"];
  const state = diagram.isHidden(id) ? "hidden" : neighboursText(sites, id);
  return [sites.label(id).name, `selected · ${state}`];
}

/** @returns the nearest site, and the rest */
function textOf(app: App, hover: Hover): [string, string] {
  const { sites } = app;
  const { questions } = app.pointer;
  const { name } = sites.label(hover.id);
  const said = [sites.info.globe ? onGlobe(app, hover, sites.info.globe) : away(hover.distance)];
  if (questions.neighbors) {
    const count = hover.neighbors.length;
    const inDual = app.diagram.neighbors(hover.id).length;
    const more = inDual === count ? "" : ` (${inDual} in the dual graph)`;
    said.push(`${count} neighbour${count === 1 ? "" : "s"}${more}`);
  }
  if (questions.under) said.push(`in ${namesOf(sites, hover.under)}`);
  if (hover.empty) {
    const unit = sites.info.globe ? " km of the map" : "";
    said.push(`empty circle of ${away(hover.empty.r).replace(" away", unit)}`);
  }
  return [name, said.join(" · ")];
}

/** In kilometres on the Earth, where another one than on the map can be the nearest. */
function onGlobe({ sites, view }: App, { id, x, y }: Hover, globe: Globe) {
  const place = placeOn(view.toWorldX(x), view.toWorldY(y));
  const distance = place && globe.distance(sites, id, place);
  if (!place || distance === null) return "nearest on the map, off the globe";
  const nearest = globe.nearest(sites, place);
  if (!nearest || nearest.id === id)
    return `${kilometres(Math.abs(distance))} ${distance < 0 ? "inside" : "away"}`;
  // Short: the tag has one line. Both are distances on the globe.
  const other = `${sites.label(nearest.id).name} ${kilometres(nearest.distance)}`;
  return `${kilometres(distance)}; nearer on Earth: ${other}`;
}

/** "−12 km" is inside. */
const kilometres = (distance: number) => `${short(distance)} km`;

function namesOf(sites: Sites, ids: ArrayLike<number>) {
  if (ids.length === 0) return "no circle";
  if (ids.length > kMostNames) return `${grouped(ids.length)} circles`;
  return Array.from(ids, (id) => sites.label(id).name).join(", ");
}

function partsOf(node: HTMLElement): [name: Element, rest: Element] {
  if (node.children.length === 0) node.append(make("b"), make("span"));
  const [name, rest] = node.children;
  return [name, rest];
}

/** Beside the pointer, where there is room. */
function place(tag: HTMLElement, { x, y }: Point, view: View) {
  const { offsetWidth: width, offsetHeight: height } = tag;
  const left = x + kGap + width < view.width - 8 ? x + kGap : x - kGap - width;
  const top = y + kGap + height < view.height - 8 ? y + kGap : y - kGap - height;
  tag.style.transform = `translate(${Math.round(Math.max(left, 4))}px, ${Math.round(top)}px)`;
}
