// The browsers that tests run in, each with its tests under its name. One that is missing is
// skipped, loudly, but not in CI.
import { findChromium, findFirefox } from "../../../tools/toolchain/browser.mjs";

const browsers = [
  ["Chromium", findChromium()],
  ["Firefox", findFirefox()],
];

/**
 * @param {string} what the name of the tests that are skipped where there is no browser
 * @param {(browser: string | null) => void} define the tests, given the path of the program;
 * in CI they are to fail without
 */
export function describeInBrowsers(what, define) {
  describe.each(browsers)("%s", (name, browser) => {
    if (!browser && !process.env.CI) {
      process.stderr.write(
        `SKIPPED: ${what} in ${name}, which is not installed. ` +
          `Set ${name.toUpperCase()} to its path.\n`,
      );
      test.skip("is installed", () => {});
      return;
    }
    define(browser);
  });
}
