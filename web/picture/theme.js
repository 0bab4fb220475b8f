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
  "pointer",
];

const property = (name) => `--${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;

/** @returns {Record<string, string>} */
export function readTheme() {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(
    kNames.map((name) => [name, style.getPropertyValue(property(name)).trim()]),
  );
}
