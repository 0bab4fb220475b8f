// The card of the selection: numbers that can be edited, and what the diagram knows about it.
import { make } from "../../shared/dom.js";
import type { App } from "../app.js";
import { messageOf } from "../../shared/errors.js";
import { neighborsOf } from "../model/neighbors.js";
import { whenever } from "../model/signals.js";
import type { Sites } from "../model/sites.js";
import { placeText } from "../model/globe.js";
import { grouped, oncePerFrame, setText, short } from "./dom.js";
import { element } from "./elements.js";

const kGrow = 1.15;
const kFree = 24; // pixels that the card leaves free around the circle that it is about
const kTallest = 340; // and how tall it can be
const kFar = 1e7; // windows for areas: this many times what the circles take

/** A term, what there is to say about it, and what a click on that does. */
type Fact = [string, string, (() => void)?];

export function makeInspector(app: App) {
  const { selection } = app;
  const card = element("inspector");
  const fields = (["x", "y", "r"] as const).map((name) => element(`card-${name}`));
  let shown = -1; // the circle that the card is about

  const update = oncePerFrame(() => {
    card.hidden = selection.size === 0;
    element("sheet").classList.toggle("has-card", selection.size > 0);
    if (selection.size === 0) {
      shown = -1;
      return;
    }
    const id = selection.single;
    if (id !== shown) leaveFree(id);
    shown = id;
    element("card-numbers").hidden = id < 0;
    if (id < 0) {
      setText(element("card-name"), `${grouped(selection.size)} circles`);
      setText(element("card-detail"), "Drag, resize or delete them together.");
      showFacts([]);
      return;
    }
    const { name, detail } = app.sites.label(id);
    setText(element("card-name"), name);
    const { x, y, r } = app.sites.site(id);
    const ring =
      r < 0
        ? `A negative radius: distances go to the far side of a ring of ${short(-r)}. ` +
          "Cells depend on the differences of radii only."
        : "";
    setText(element("card-detail"), [detail ?? "", ring].filter(Boolean).join(". "));
    [x, y, r].forEach((value, k) => {
      if (document.activeElement !== fields[k]) fields[k].value = String(value);
    });
    showFacts(factsOf(app, id));
  });

  /** The card goes to the other side if it would lie on the circle that it is about. */
  function leaveFree(id: number) {
    card.classList.remove("aside");
    if (id < 0) return;
    const { x, y } = app.sites.site(id);
    const [px, py] = [app.view.toScreenX(x), app.view.toScreenY(y)];
    const { left, right, top } = card.getBoundingClientRect();
    const isBelow = px > left - kFree && px < right + kFree && py > top && py < top + kTallest;
    card.classList.toggle("aside", isBelow);
  }

  function showFacts(facts: Fact[]) {
    element("card-facts").replaceChildren(
      ...facts.flatMap(([term, text, act]) => {
        const said = act ? make("button", { type: "button", onclick: act }, text) : text;
        return [make("dt", {}, term), make("dd", {}, said)];
      }),
    );
  }

  fields.forEach((field, k) => {
    field.addEventListener("change", () => {
      const id = selection.single;
      const value = field.valueAsNumber;
      if (id < 0 || Number.isNaN(value)) return;
      const { x, y, r } = app.sites.site(id);
      const xyr = Float64Array.of(x, y, r);
      xyr[k] = value;
      try {
        app.model.update([id], xyr);
      } catch (error) {
        field.setCustomValidity(messageOf(error));
        field.reportValidity();
      }
    });
    field.addEventListener("input", () => field.setCustomValidity(""));
    field.addEventListener("keydown", (event) => {
      if (event.key === "Escape") element("overlay").focus();
    });
  });
  element("card-larger").addEventListener("click", () => app.edits.grow(kGrow));
  element("card-smaller").addEventListener("click", () => app.edits.grow(1 / kGrow));
  element("card-duplicate").addEventListener("click", () => app.edits.duplicate());
  element("card-delete").addEventListener("click", () => {
    app.edits.removeSelected();
    element("overlay").focus(); // the button goes away
  });
  element("card-close").addEventListener("click", () => {
    selection.clear();
    element("overlay").focus();
  });
  whenever(() => selection.ids, update);
  app.model.on("change", update);
}

function factsOf(app: App, id: number): Fact[] {
  const { diagram, sites, selection } = app;
  const onGlobe = globeFacts(app, id);
  if (diagram.isHidden(id)) {
    const cover = diagram.coverOf(id);
    return [
      ...onGlobe,
      ["cell", "none: it is hidden"],
      ["lies inside", sites.label(cover).name, () => selection.set([cover])],
    ];
  }
  const { areaUnit } = sites.info;
  const area = areaOf(app, id);
  return [
    ...onGlobe,
    ["cell’s area", area === null ? "unbounded" : [area, areaUnit].filter(Boolean).join(" ")],
    ["neighbours", neighboursOf(sites, id)],
    ["hidden inside it", hiddenBelow(app, id)],
  ];
}

/** Where it is on the Earth, and which one is next to it there: x and y are those of the map. */
function globeFacts({ sites, selection }: App, id: number): Fact[] {
  const { globe } = sites.info;
  const place = globe?.placeOf(sites, id);
  if (!globe || !place) return [];
  const next = globe.nearestCentre(sites, id);
  const facts: Fact[] = [["place", placeText(place)]];
  if (next) {
    const text = `${sites.label(next.id).name}, ${short(next.distance)} km`;
    facts.push(["nearest centre", text, () => selection.set([next.id])]);
  }
  return facts;
}

/** Those with an edge in common; the dual graph can have more. */
function neighboursOf(sites: Sites, id: number) {
  const count = neighborsOf(sites, id).length;
  const inDual = sites.diagram.neighbors(id).length;
  if (count === inDual) return String(count);
  return `${count} (${inDual} in the dual graph, which joins some cells that meet in a point only)`;
}

/** The whole cell's, or null if it does not end. */
function areaOf({ diagram, sites, painter }: App, id: number) {
  if (painter.ends) return short(painter.ends.cellArea(id));
  const { x, y, r } = sites.site(id);
  const reach = kFar * Math.max(r, 1);
  const window = diagram.voronoi([x - reach, y - reach, x + reach, y + reach]);
  const isOpen = window.cellCurves(id)?.neighbors.includes(-1);
  return isOpen ? null : short(window.cellArea(id));
}

/** How many circles this one covers. */
function hiddenBelow({ diagram, sites }: App, id: number) {
  if (diagram.hiddenSize === 0) return "none";
  const { x, y } = sites.site(id);
  const r = sites.radius(id);
  // A circle that it covers contains no point farther away, and is deep inside it at its own
  // centre.
  const count = Array.from(diagram.within(x, y, r)).filter((other) => {
    if (other === id || !sites.isHidden(other)) return false;
    const site = sites.site(other);
    return Math.hypot(site.x - x, site.y - y) + sites.radius(other) <= r;
  }).length;
  return count === 0 ? "none" : grouped(count);
}
