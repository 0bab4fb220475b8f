// The tools' gestures, as the tools describe them.
import { make } from "../../shared/dom.js";
import { kTools } from "../tools/registry.js";
import { element } from "./elements.js";

export function makeHelp() {
  for (const kind of ["fine", "coarse"] as const) {
    const sentences = kTools.flatMap(({ help }) => help?.[kind] ?? []);
    element(`help-${kind}`).append(...partsOf(sentences.join(" ")));
  }
}

/** Text, and what is between asterisks in bold. */
const partsOf = (text: string) =>
  text.split("*").map((part, k) => (k % 2 === 0 ? part : make("b", {}, part)));
