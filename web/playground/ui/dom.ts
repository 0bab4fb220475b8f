// Numbers as text, and texts that change with the next frame.

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

export function duration(ms: number) {
  const micros = ms * 1000;
  if (ms >= 1e4) return `${(ms / 1000).toFixed(0)} s`;
  if (ms >= 1e3) return `${(ms / 1000).toFixed(1)} s`;
  if (ms >= 10) return `${ms.toFixed(0)} ms`;
  if (ms >= 1) return `${ms.toFixed(1)} ms`;
  return `${micros.toFixed(micros < 10 ? 1 : 0)} µs`;
}

/** A distance in words. */
export const away = (distance: number) =>
  `${short(Math.abs(distance))} ${distance < 0 ? "inside" : "away"}`;

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
