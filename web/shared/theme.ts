// The colours of theme.css, which canvases take from there: light and dark are in one place.

const kNames = [
  "sans",
  "paper",
  "ink",
  "quiet",
  "line",
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
  "ok",
  "pointer",
] as const;

export type ThemeName = (typeof kNames)[number];
export type Theme = Readonly<Record<ThemeName, string>>;

/** The name of a colour in theme.css. */
export const variableOf = (name: ThemeName) =>
  `--${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;

/** As it is now. */
export function readTheme(): Theme {
  const style = getComputedStyle(document.documentElement);
  const values = kNames.map((name) => [name, style.getPropertyValue(variableOf(name)).trim()]);
  return Object.fromEntries(values) as Theme; // as it has all names
}

export function whenThemeChanges(act: () => void) {
  for (const query of ["(prefers-color-scheme: dark)", "(forced-colors: active)"])
    matchMedia(query).addEventListener("change", act);
}
