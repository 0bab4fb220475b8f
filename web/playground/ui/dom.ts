// Numbers as text, and texts that change with the next frame.
import { neighborsOf } from "../model/neighbors.js";
import type { Sites } from "../model/sites.js";

const thin = "\u202f";
const whole = new Intl.NumberFormat("en", { maximumFractionDigits: 0 });

export const grouped = (n: number) => whole.format(n).replaceAll(",", thin);

/** Three significant digits, without an exponent where that reads well. */
export function short(value: number) {
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e7))
    return value.toExponential(2).replaceAll("-", "\u2212");
  const digits = size >= 100 || size === 0 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3;
  const [integer, fraction] = value.toFixed(digits).replace("-", "\u2212").split(".");
  const head = integer.replace(/\B(?=(\d{3})+(?!\d))/g, thin);
  return fraction ? `${head}.${fraction}` : head;
}

/** One significant digit, as more of it changes from run to run. */
export function duration(ms: number) {
  const inUnit = (value: number) => String(Number(value.toPrecision(1)));
  if (ms >= 950) return `${inUnit(ms / 1000)} s`;
  if (ms >= 0.95) return `${inUnit(ms)} ms`;
  return `${inUnit(1000 * ms)} µs`;
}

/** A distance in words. */
export const away = (distance: number) =>
  `${short(Math.abs(distance))} ${distance < 0 ? "inside" : "away"}`;

/** How many neighbours a site has, in words. */
export function neighboursText(sites: Sites, id: number) {
  const { length } = neighborsOf(sites, id);
  return `${length} neighbour${length === 1 ? "" : "s"}`;
}

/** Sets a text if it has changed: the browser lays out nothing else. */
export function setText(node: Element, text: string) {
  if (node.textContent !== text) node.textContent = text;
}

let waiting = 0; // updates that come with the next frame

/** Runs something once in the next frame, however often it is asked for. */
export function oncePerFrame(run: () => void) {
  let isAsked = false;
  return () => {
    if (isAsked) return;
    isAsked = true;
    waiting++;
    requestAnimationFrame(() => {
      isAsked = false;
      waiting--;
      run();
    });
  };
}

/** Whether all that `oncePerFrame` was asked for has run. */
export const isUpToDate = () => waiting === 0;
