// Browsers for the page's tests, against tools/serve.mjs: Chromium driven by playwright-core, and
// Firefox by puppeteer-core.
import { setTimeout as timeout } from "node:timers/promises";
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, test } from "@jest/globals";
import { chromium } from "playwright-core";
import puppeteer from "puppeteer-core";
import { serve } from "../../../tools/serve.mjs";
import { findChromium, findFirefox } from "../../../tools/toolchain/browser.mjs";

/** Ends what hangs, in milliseconds, before Jest does: no time decides whether a test passes. */
export const kHangs = 300_000;

const kArguments = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-dev-shm-usage",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--site-per-process", // as the browser with windows has it
  "--process-per-site", // a process keeps what it has loaded
];

/**
 * A group of tests with a browser. Without one they are skipped, and say so; in CI that is a
 * failure.
 */
function describeWith(browserName, path, name, start, define) {
  if (!path) {
    if (process.env.CI) {
      test(`${name}: there is a browser`, () => {
        throw new Error(`no ${browserName} found: install it, or set its path`);
      });
      return;
    }
    process.stderr.write(
      `SKIPPED: ${name}. No ${browserName} found: install it, or set its path.\n`,
    ); // Jest would hide console.warn
    describe.skip(name, () => define(async () => null));
    return;
  }
  describe(name, () => {
    let browser;
    let server;
    beforeAll(async () => {
      server = await serve(0, { caching: "max-age=3600" });
      browser = await start(path);
    });
    afterAll(async () => {
      await browser?.close();
      await server?.close();
    });
    define((options) => start.open(browser, server.url, options), {
      url: () => server.url,
      browser: () => browser,
    });
  });
}

/** WebGL without a graphics card. */
const kWebGL = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

const startChromium = (executablePath) => chromium.launch({ executablePath, args: kArguments });
const startWithWebGL = (executablePath) => {
  const args = [...kArguments.filter((one) => one !== "--disable-gpu"), ...kWebGL];
  return chromium.launch({ executablePath, args });
};
/** Firefox with this colour scheme: its preferences are fixed when it starts. */
const firefoxWith = (colorScheme) => {
  const start = (executablePath) =>
    puppeteer.launch({
      browser: "firefox",
      executablePath,
      headless: true,
      extraPrefsFirefox: {
        "ui.prefersReducedMotion": 1, // as in openPage
        "layout.css.prefers-color-scheme.content-override": colorScheme === "dark" ? 0 : 1,
      },
    });
  start.open = openInFirefox;
  return start;
};
startChromium.open = openPage;
startWithWebGL.open = openPage;

/**
 * @param {string} name
 * @param {(open: (options?: object) => Promise<import("playwright-core").Page>) => void} define
 *   gets a function that opens the page; `page.errors` lists what went wrong in it: exceptions,
 *   console errors, refused or failed requests
 */
export const describeInBrowser = (name, define) =>
  describeWith("Chromium", findChromium(), name, startChromium, define);

/** As describeInBrowser, with WebGL, which is slow to start. */
export const describeWithWebGL = (name, define) =>
  describeWith("Chromium", findChromium(), name, startWithWebGL, define);

/** As describeInBrowser, in Firefox; pages are Puppeteer's. */
export const describeInFirefox = (name, define, { colorScheme = "light" } = {}) =>
  describeWith("Firefox", findFirefox(), name, firefoxWith(colorScheme), define);

/** Time between two questions to a page, in milliseconds. */
const kPolling = 20;

/** Time that a page gets for a frame, in milliseconds, before a picture of it makes one. */
const kFrameDue = 10_000;

/**
 * Playwright's `waitForFunction`, with two differences. It asks by the clock: by default Playwright
 * asks with each frame, and a page that a busy machine has not shown yet gets none. From time to
 * time it takes a picture, which makes a frame, for code in the page that waits for one. If it
 * fails, the error tells what the page was doing.
 */
function waitByClock(page) {
  const wait = page.waitForFunction.bind(page);
  return async (isDone, argument, options) => {
    const makeFrame = () => page.screenshot().catch(() => {}); // fails on a page that is left
    const frames = setInterval(makeFrame, kFrameDue);
    try {
      return await wait(isDone, argument, { polling: kPolling, ...options });
    } catch (cause) {
      const state = () => [location.href, document.readyState, document.visibilityState];
      const seen = await Promise.race([page.evaluate(state), timeout(5_000, ["no answer"])]);
      throw new Error(`waited in vain: ${[...seen, ...page.errors].join(", ")}`, { cause });
    } finally {
      clearInterval(frames);
    }
  };
}

const whenReady = (name) => window[name] !== undefined;

/** @param {string | (() => boolean)} ready a global's name, or a function to call in the page */
const becomeReady = (page, ready) =>
  typeof ready === "function"
    ? page.waitForFunction(ready)
    : page.waitForFunction(whenReady, ready);

/**
 * Chromium says this when an address of the machine comes or goes, in a container say. It drops
 * what it is loading then, from the machine itself too.
 */
const kNetworkChanged = "net::ERR_NETWORK_CHANGED";

/** Opens an address in a page; again, at most twice, if the machine's network changed. */
async function load(page, address, ready) {
  const isDropped = () => page.isDropped;
  for (let again = 2; ; --again) {
    page.errors.length = 0;
    page.isDropped = false;
    try {
      await page.goto(address);
      if (ready && !isDropped()) {
        const drop = page.waitForEvent("requestfailed", { predicate: isDropped, timeout: 0 });
        await Promise.race([becomeReady(page, ready), drop]);
      }
      if (!isDropped()) return;
    } catch (error) {
      if (!isDropped()) throw error;
    }
    if (again === 0) throw new Error(`${address}: ${kNetworkChanged}`);
  }
}

const pathOf = (path) => (/^(#|$)/.test(path) ? `playground/${path}` : path);

const kViewport = { width: 1280, height: 800 };
async function newContext(browser, options) {
  const all = { viewport: kViewport, reducedMotion: "reduce", ...options };
  const context = await browser.newContext(all);
  context.setDefaultTimeout(kHangs);
  return context;
}

/** For each browser, the context of all pages that need none of their own. */
const sharedContexts = new WeakMap();

async function sharedContext(browser, url) {
  if (!sharedContexts.has(browser)) {
    const context = await newContext(browser);
    sharedContexts.set(browser, context);
    const keeper = await context.newPage(); // keeps the process from page to page
    await keeper.goto(`${url}icon.svg`);
  }
  return sharedContexts.get(browser);
}

/**
 * `path` is below the site's folder, and without one, or with what follows "#", the playground's;
 * `ready` is the global that says that the page is ready, or a function that is asked in the page;
 * `site` is another server's; `prepare` gets the page before it is opened; `isAlone`: in
 * a process of its own; other options are Playwright's. Motion is reduced, so that nothing moves by
 * itself, unless the options say otherwise.
 */
async function openPage(browser, url, options = {}) {
  const { path = "", ready = "app", site = url, viewport = kViewport, ...more } = options;
  const { prepare, isAlone, ...others } = more;
  const isOwn = isAlone || prepare || site !== url || Object.keys(others).length > 0;
  const context = isOwn
    ? await newContext(browser, { viewport, ...others })
    : await sharedContext(browser, url);
  const page = await context.newPage();
  if (!isOwn) await page.setViewportSize(viewport);
  page.errors = [];
  page.waitForFunction = waitByClock(page);
  page.isDropped = false; // something, by the network: no error of the page's
  const fail = (text) => {
    if (text.includes(kNetworkChanged)) page.isDropped = true;
    else page.errors.push(text);
  };
  page.on("console", (message) => message.type() === "error" && fail(message.text()));
  page.on("pageerror", (error) => page.errors.push(String(error)));
  page.on("requestfailed", (request) => {
    // A page that is left drops its requests: no failure.
    const { errorText } = request.failure();
    if (errorText !== "net::ERR_ABORTED") fail(`failed: ${request.url()}, ${errorText}`);
  });
  page.on(
    "response",
    (response) =>
      response.status() >= 400 && page.errors.push(`${response.status()}: ${response.url()}`),
  );
  await prepare?.(page);
  await load(page, site + pathOf(path), ready);
  return page;
}

async function openInFirefox(browser, url, options = {}) {
  const { path = "", ready = "app", width = 1280, height = 800 } = options;
  const page = await browser.newPage();
  page.setDefaultTimeout(kHangs);
  page.errors = [];
  page.on("console", (message) => message.type() === "error" && page.errors.push(message.text()));
  page.on("pageerror", (error) => page.errors.push(String(error)));
  await page.setViewport({ width, height });
  await page.goto(url + pathOf(path));
  if (ready) await page.waitForFunction(whenReady, {}, ready);
  return page;
}

/**
 * For each test of a group a page of its own, which `use` gets; afterwards its diagram is sound and
 * nothing has gone wrong in it.
 * @param {(options?: object) => Promise<any>} open what `define` gets
 */
export function forEachPage(open, use, options = {}) {
  let page;
  beforeEach(async () => {
    page = await open(options);
    await use(page);
  });
  afterEach(async () => {
    expect((await stateOf(page)).broken).toBeNull();
    expect(page.errors).toEqual([]);
    await closePage(page);
  });
}

/** @param {any} page Playwright's, with its context if that is its own, or Puppeteer's */
export function closePage(page) {
  const context = page.context?.();
  const isShared = context && sharedContexts.get(context.browser()) === context;
  return (context && !isShared ? context : page).close();
}

/** Resolves when the page says that its canvases and panels show what was asked for. */
export const settled = (page) => page.evaluate(() => app.whenShown());

/** Waits for some frames of the page, in which something wrong would happen. */
export const frames = (page, count) =>
  page.evaluate(async (count) => {
    for (let k = 0; k < count; k++) await new Promise(requestAnimationFrame);
  }, count);

/** Shows another set. */
export async function show(page, key, params = {}) {
  await page.evaluate(([key, params]) => app.navigation.load(key, params), [key, params]);
  await settled(page);
}

/** Circles of the test's own, x, y, r of each, with no way back. */
export const showCircles = (page, xyr) =>
  page.evaluate((xyr) => {
    const { Sites } = app.parts;
    const info = { key: "data", title: "Test" };
    app.model.replace(new Sites(Float64Array.from(xyr), info, { original: new Float64Array(0) }));
    app.camera.fit();
  }, xyr);

/** Pixel position and radius of a site. */
export const whereIs = (page, id) =>
  page.evaluate((id) => {
    const { x, y, r } = app.diagram.site(id);
    return { x: app.view.toScreenX(x), y: app.view.toScreenY(y), r: r * app.view.scale };
  }, id);

/** The pixel between the bars that is farthest from every circle. */
export const freeSpace = (page) =>
  page.evaluate(() => {
    const { top, bottom } = app.camera.insets();
    let best = { clearance: -Infinity };
    for (let x = 330; x < innerWidth - 330; x += 15) {
      for (let y = top + 30; y < innerHeight - bottom - 30; y += 15) {
        const { distance } = app.diagram.nearest(app.view.toWorldX(x), app.view.toWorldY(y)) ?? {
          distance: Infinity,
        };
        const clearance = distance * app.view.scale;
        if (clearance > best.clearance) best = { x, y, clearance };
      }
    }
    return best;
  });

/** Visible sites whose circles are in the open: a click on the centre hits it. */
export const sitesInReach = (page, count = 1) =>
  page.evaluate((count) => {
    const { top, bottom } = app.camera.insets();
    const found = [];
    for (const id of app.diagram.ids()) {
      const { x, y } = app.diagram.site(id);
      const px = app.view.toScreenX(x);
      const py = app.view.toScreenY(y);
      const isInside = px > 330 && px < innerWidth - 330 && py > top + 10;
      if (!isInside || py > innerHeight - bottom - 60) continue;
      if (!app.diagram.isHidden(id) && app.pointer.circlesAt(px, py, 5)[0] === id) found.push(id);
      if (found.length === count) break;
    }
    return found;
  }, count);

/** Sizes, and the answer of the exact check: null if the diagram is sound. */
export const stateOf = (page) =>
  page.evaluate(() => ({
    size: app.diagram.size,
    visible: app.diagram.visibleSize,
    hidden: app.diagram.hiddenSize,
    selected: [...app.selection.ids],
    broken: app.parts.validate(app.diagram),
  }));

/** All circles, by id: what two states are compared by. */
export const circlesOf = (page) =>
  page.evaluate(() =>
    Array.from(app.diagram.ids(), (id) => [id, ...Object.values(app.diagram.site(id))]),
  );

/** The number of pixels of a canvas that are not transparent. */
export const painted = (page, name) =>
  page.evaluate((name) => {
    app.painter.flush();
    const canvas = app.painter.canvas(name);
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let k = 3; k < data.length; k += 4) if (data[k] > 0) count++;
    return count;
  }, name);

export { press } from "./keys.mjs";

/** Drags the mouse in steps. */
export async function drag(page, from, to, steps = 8) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps });
  await page.mouse.up();
}
