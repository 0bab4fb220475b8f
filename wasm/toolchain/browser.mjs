// A Chromium for the tests of the page.
import { candidate, ensureInstalled, hasApt } from "./apt.mjs";
import { say, which } from "./process.mjs";

function found() {
  return process.env.CHROMIUM ?? which("chromium") ?? which("google-chrome") ?? which("google-chrome-stable");
}

/** The path of a Chromium, installed if need be; null if none can be had. */
export function ensureChromium() {
  const browser = found();
  if (browser) return browser;
  try {
    if (hasApt() && candidate("chromium") !== null) ensureInstalled(["chromium"], "the page's tests in a browser");
  } catch (error) {
    say(error.message);
  }
  return found();
}
