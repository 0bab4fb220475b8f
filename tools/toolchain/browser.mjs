// Browsers for the tests: Chromium for the page, both for the package.
import { candidate, ensureInstalled, hasApt } from "./apt.mjs";
import { say, which } from "./process.mjs";

const kChromium = ["chromium-headless-shell", "chromium", "google-chrome", "google-chrome-stable"];
const kFirefox = ["firefox-esr", "firefox"];

const find = (given, programs) =>
  given || (programs.map(which).find((program) => program !== null) ?? null);

/** The path of a Chromium that is there, CHROMIUM first; null for none. */
export const findChromium = () => find(process.env.CHROMIUM, kChromium);

/** The path of a Firefox that is there, FIREFOX first; null for none. */
export const findFirefox = () => find(process.env.FIREFOX, kFirefox);

function ensureBrowser(found, debianPackages, why) {
  const browser = found();
  if (browser) return browser;
  try {
    const known = hasApt() && debianPackages.find((name) => candidate(name) !== null);
    if (known) ensureInstalled([known], why);
  } catch (error) {
    say(error.message);
  }
  return found();
}

/**
 * The path of a Chromium, installed if need be; null if none can be had. Its headless shell is the
 * same engine without the windows of the browser, in which the page's tests take two thirds of the
 * time.
 */
export function ensureChromium() {
  const packages = ["chromium-headless-shell", "chromium"];
  return ensureBrowser(findChromium, packages, "the tests in a browser");
}

/** The path of a Firefox, installed if need be; null if none can be had. */
export function ensureFirefox() {
  return ensureBrowser(findFirefox, ["firefox-esr"], "the tests in a second browser");
}
