// The way from a figure to the playground, with the figure's circles.

const kMost = 500; // circles that an address can hold
const short = (value: number) => String(Number(value.toPrecision(7)));

/** @param circles x, y, r of each, y downwards as in a figure: the playground has y upwards */
export function playgroundLink(circles: ArrayLike<number>): string {
  const count = Math.min(circles.length / 3, kMost);
  const edits = Array.from({ length: count }, (_, k) =>
    [circles[3 * k], -circles[3 * k + 1], circles[3 * k + 2]].map(short).join(),
  );
  const root = document.documentElement.dataset.root ?? "./";
  return `${root}playground/#set=data&edits=${edits.join("~")}`;
}
