// The canvas takes its colours from the style sheet, so that light and dark are defined in one
// place: style.css.

const kNames = [
  "sans",
  "paper",
  "ink",
  "name",
  "sea",
  "land",
  "coast",
  "cell",
  "site",
  "siteFill",
  "hidden",
  "hiddenFill",
  "distance",
  "dual",
  "selectedFill",
  "emptyFill",
  "centres",
  "hull",
  "level",
  "vertex",
  "empty",
  "selected",
  "accent",
  "accentFill",
  "accentSite",
  "neighbor",
  "neighborFill",
  "wrong",
  "wrongFill",
  "pointer",
] as const;

const property = (name: string) =>
  `--${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;

export type Theme = Record<(typeof kNames)[number], string>;

export function readTheme(): Theme {
  const style = getComputedStyle(document.documentElement);
  const colors = kNames.map((name) => [name, style.getPropertyValue(property(name)).trim()]);
  return Object.fromEntries(colors) as Theme; // as it has all names
}
