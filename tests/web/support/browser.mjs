// A browser for the page's tests: Chromium as installed, driven by playwright-core, against
// tools/serve.mjs.
import { existsSync } from "node:fs";
import { afterAll, beforeAll, describe, test } from "@jest/globals";
import { chromium } from "playwright-core";
import { serve } from "../../../tools/serve.mjs";

const kCandidates = [
  process.env.CHROMIUM,
  process.env.CHROME_PATH,
  "/usr/bin/chromium",
  "/usr/bin/google-chrome",
];
const kArguments = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-dev-shm-usage",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

const executablePath = kCandidates.find((path) => path && existsSync(path));

/**
 * A group of tests with a browser. Without one they are skipped, and say so; in CI that is a
 * failure.
 * @param {string} name
 * @param {(open: (options?: object) => Promise<import("playwright-core").Page>) => void} define
 *   gets a function that opens the page; `page.errors` lists what went wrong in it: exceptions,
 *   console errors, refused or failed requests
 */
export function describeInBrowser(name, define) {
  if (!executablePath) {
    if (process.env.CI) {
      test(`${name}: there is a browser`, () => {
        throw new Error("no Chromium found: install it, or set CHROMIUM to its path");
      });
      return;
    }
    process.stderr.write(
      `SKIPPED: ${name}. No Chromium found: install it, or set CHROMIUM to its path.\n`,
    ); // Jest would hide console.warn
    describe.skip(name, () => define(async () => null));
    return;
  }
  describe(name, () => {
    let browser;
    let server;
    beforeAll(async () => {
      server = await serve(0);
      browser = await chromium.launch({ executablePath, args: kArguments });
    });
    afterAll(async () => {
      await browser?.close();
      await server?.close();
    });
    define((options) => openPage(browser, server.url, options));
  });
}

/**
 * `path` is below the page's folder, `ready` the global that says that the page is; other options
 * are Playwright's.
 */
async function openPage(browser, url, { path = "", ready = "app", ...options } = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const page = await context.newPage();
  page.errors = [];
  page.on("console", (message) => message.type() === "error" && page.errors.push(message.text()));
  page.on("pageerror", (error) => page.errors.push(String(error)));
  page.on("requestfailed", (request) => page.errors.push(`failed: ${request.url()}`));
  page.on(
    "response",
    (response) =>
      response.status() >= 400 && page.errors.push(`${response.status()}: ${response.url()}`),
  );
  await page.goto(url + path);
  await page.waitForFunction((name) => window[name] !== undefined, ready, { timeout: 10_000 });
  return page;
}

/** Two frames later: what was asked for has been drawn, and the panel shows it. */
export const settled = (page) =>
  page.evaluate(
    () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
  );

/** Pixel position and radius of a site. */
export const whereIs = (page, id) =>
  page.evaluate((id) => {
    const { x, y, r } = app.diagram.site(id);
    return { x: app.view.toScreenX(x), y: app.view.toScreenY(y), r: r * app.view.scale };
  }, id);

/** The pixel right of the panel that is farthest from every circle. */
export const freeSpace = (page) =>
  page.evaluate(() => {
    let best = { clearance: -Infinity };
    for (let x = 340; x < innerWidth - 60; x += 15) {
      for (let y = 60; y < innerHeight - 120; y += 15) {
        const { distance } = app.diagram.nearest(app.view.toWorldX(x), app.view.toWorldY(y)) ?? {
          distance: Infinity,
        };
        const clearance = distance * app.view.scale;
        if (clearance > best.clearance) best = { x, y, clearance };
      }
    }
    return best;
  });

/** A visible site whose circle is in the open: a click on its centre hits it. */
export const sitesInReach = (page, count = 1) =>
  page.evaluate((count) => {
    const found = [];
    for (const id of app.diagram.ids()) {
      const { x, y } = app.diagram.site(id);
      const px = app.view.toScreenX(x);
      const py = app.view.toScreenY(y);
      const inWindow = px > 340 && px < innerWidth - 60 && py > 60 && py < innerHeight - 140;
      if (inWindow && !app.diagram.isHidden(id) && app.pick(px, py, 5) === id) found.push(id);
      if (found.length === count) break;
    }
    return found;
  }, count);

/** Sizes, and what the exact check says: null if the diagram is sound. */
export const stateOf = (page) =>
  page.evaluate(() => ({
    size: app.diagram.size,
    visible: app.diagram.visibleSize,
    hidden: app.diagram.hiddenSize,
    selected: app.selected,
    broken: app.diagram.validate(),
  }));
