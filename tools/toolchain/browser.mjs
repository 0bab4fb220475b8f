// Browsers for the tests: Chromium for the page, both for the package.
import { candidate, ensureInstalled, hasApt } from "./apt.mjs";
import { say, which } from "./process.mjs";

function ensureBrowser(given, programs, debianPackages, why) {
  const found = () => given ?? programs.map(which).find((program) => program !== null) ?? null;
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
  return ensureBrowser(
    process.env.CHROMIUM,
    ["chromium-headless-shell", "chromium", "google-chrome", "google-chrome-stable"],
    ["chromium-headless-shell", "chromium"],
    "the tests in a browser",
  );
}

/** The path of a Firefox, installed if need be; null if none can be had. */
export function ensureFirefox() {
  return ensureBrowser(
    process.env.FIREFOX,
    ["firefox-esr", "firefox"],
    ["firefox-esr"],
    "the package's tests in a second browser",
  );
}
