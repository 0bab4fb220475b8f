// The browsers that tests run in, each with its tests under its name. One that is missing is
// skipped, loudly, but not in CI.
import { existsSync } from "node:fs";

const browsers = [
  ["Chromium", process.env.CHROMIUM, "/usr/bin/chromium"],
  ["Firefox", process.env.FIREFOX, "/usr/bin/firefox-esr"],
];

/**
 * @param {string} what is skipped where there is no browser
 * @param {(browser: string | undefined) => void} define the tests, given the path of the program;
 * in CI they are to fail without
 */
export function describeInBrowsers(what, define) {
  describe.each(browsers)("%s", (name, given, usual) => {
    const browser = [given, usual].find((file) => file && existsSync(file));
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
