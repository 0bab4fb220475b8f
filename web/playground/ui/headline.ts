// The headline, and a sentence below it. In the state Centres they say what is
// true there, and on how much of the window the nearest centre is not the nearest circle's.
import type { App } from "../app.js";
import { effect, signal, whenever } from "../model/signals.js";
import { wrongShare } from "../picture/wrong_share.js";
import type { Weights } from "../motion/weights.js";
import { setText } from "./dom.js";
import { element } from "./elements.js";

const kRest = 350; // ms without a change, after which places are asked

const percent = (share: number) => {
  const rounded = Math.round(100 * share);
  if (rounded === 0 && share > 0) return "less than 1 %";
  return `${rounded} %`;
};

export function makeHeadline(app: App, weights: Weights) {
  /** Of the window, where centres pick wrongly; null while it is not known. */
  const wrong = signal<number | null>(null);
  let waiting = 0;

  const judge = () => {
    const isOpen = app.painter.isLive || app.model.open !== null;
    if (isOpen) judgeLater();
    else wrong.value = weights.target === 0 ? wrongShare(app.sites, app.view) : null;
  };
  const judgeLater = () => {
    clearTimeout(waiting);
    waiting = setTimeout(judge, kRest);
  };
  const changed = () => {
    if (weights.target !== 0) wrong.value = null;
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
    element("verdict").classList.toggle("wrong", (wrong.value ?? 0) > 0);
    if (isCentres) setText(element("verdict"), sentenceOf(app, wrong.value));
  }

  effect(show);
  whenever(() => [weights.target, app.looks], changed);
  app.model.on("change", ({ isSet }) => {
    if (isSet) wrong.value = null;
    changed();
  });
}

function sentenceOf({ sites }: App, wrong: number | null) {
  if (sites.size === 0) return "No circles: nothing is picked.";
  if (wrong !== null) return `Centres pick wrongly on ${percent(wrong)} of this picture.`;
  if (sites.weight !== 1 && !sites.truth)
    return "For more than 100\u202f000 circles, wrong picks are not counted.";
  return "The cells are those of the centres.";
}
