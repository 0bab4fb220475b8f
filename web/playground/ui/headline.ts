// The headline, and a sentence below it. In the state Centres they say what is
// true there, and on how much of the window the nearest centre is not the nearest circle's.
import type { App } from "../app.js";
import { effect, signal, whenever } from "../model/signals.js";
import { type Verdict, verdictOf } from "../model/verdict.js";
import type { Weights } from "../motion/weights.js";
import { setText } from "./dom.js";
import { element } from "./elements.js";

const kRest = 350; // ms without a change, after which places are asked

const percent = (share: number) => {
  const rounded = Math.round(100 * share);
  if (rounded === 0 && share > 0) return "less than 1 %";
  return `${rounded} %`;
};

/** @returns what was found last, or null while it is not known */
export function makeHeadline(app: App, weights: Weights) {
  const verdict = signal<Verdict | null>(null);
  let waiting = 0;

  const judge = () => {
    const isOpen = app.painter.isLive || app.model.open !== null;
    if (isOpen) judgeLater();
    else verdict.value = weights.target === 0 ? verdictOf(app.sites, app.view, freeBox(app)) : null;
  };
  const judgeLater = () => {
    clearTimeout(waiting);
    waiting = setTimeout(judge, kRest);
  };
  const changed = () => {
    if (weights.target !== 0) verdict.value = null;
    show();
    if (weights.target === 0) judgeLater();
    else clearTimeout(waiting);
  };

  function show() {
    const isCentres = weights.target === 0;
    const [is, isNot] = isCentres ? ["centre", "circle"] : ["circle", "centre"];
    setText(element("headline-is"), `The nearest ${is},`);
    setText(element("headline-not"), `not the nearest ${isNot}`);
    setText(element("about"), isCentres ? "" : (app.sites.info.about ?? ""));
    element("verdict").hidden = !isCentres;
    element("verdict").classList.toggle("wrong", (verdict.value?.share ?? 0) > 0);
    if (isCentres) setText(element("verdict"), sentenceOf(app, verdict.value));
  }

  effect(show);
  whenever(() => [weights.target, app.looks], changed);
  app.model.on("change", ({ isSet }) => {
    if (isSet) verdict.value = null;
    changed();
  });
  return verdict;
}

function sentenceOf({ sites }: App, verdict: Verdict | null) {
  if (sites.size === 0) return "No circles: nothing is picked.";
  if (verdict) return `Centres pick wrongly on ${percent(verdict.share)} of this picture.`;
  if (sites.weight !== 1 && !sites.truth)
    return "For more than 100\u202f000 circles, wrong picks are not counted.";
  return "The cells are those of the centres.";
}

/** The part of the window that no bar covers, in pixels. */
function freeBox({ view, insets }: App) {
  const { left, top, right, bottom } = insets();
  const margin = 20;
  return {
    left: left + margin,
    top: top + margin,
    right: view.width - right - margin,
    bottom: view.height - bottom - margin,
  };
}
