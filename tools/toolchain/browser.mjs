// Browsers for the tests: Chromium for the page, both for the package.
import { candidate, ensureInstalled, hasApt } from "./apt.mjs";
import { say, which } from "./process.mjs";

function ensureBrowser(given, programs, debianPackage, why) {
  const found = () => given ?? programs.map(which).find((program) => program !== null) ?? null;
  const browser = found();
  if (browser) return browser;
  try {
    if (hasApt() && candidate(debianPackage) !== null) ensureInstalled([debianPackage], why);
  } catch (error) {
    say(error.message);
  }
  return found();
}

/** The path of a Chromium, installed if need be; null if none can be had. */
export function ensureChromium() {
  return ensureBrowser(
    process.env.CHROMIUM,
    ["chromium", "google-chrome", "google-chrome-stable"],
    "chromium",
    "the tests in a browser",
  );
}

/** The path of a Firefox, installed if need be; null if none can be had. */
export function ensureFirefox() {
  return ensureBrowser(
    process.env.FIREFOX,
    ["firefox-esr", "firefox"],
    "firefox-esr",
    "the package's tests in a second browser",
  );
}
