// The pages of the site, in Chromium and in Firefox: each figure starts and answers mouse, touch
// and keyboard; nothing goes wrong or is wider than the window. In Chromium also: axe finds
// nothing, links lead somewhere, each page has its first picture before any script.
import { mkdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { fileURLToPath } from "node:url";
import { beforeAll, describe, expect, test } from "@jest/globals";
import { documents } from "../../tools/site/documents.mjs";
import { kPages } from "../../tools/site/list.mjs";
import { closePage, describeInBrowser, describeInFirefox } from "./support/browser.mjs";
import { isThorough } from "../support/effort.mjs";
import {
  figuresOf,
  reach,
  touchInChromium,
  touchInFirefox,
  tryByFinger,
  tryByMouseAndKeyboard,
} from "./support/figures.mjs";

const pictures = fileURLToPath(new URL("../../build/pictures/", import.meta.url));
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const addressOf = ({ folder }) => (folder ? `${folder}/` : "./");
const withFigures = kPages.map((page) => [page.key, addressOf(page)]);
const documented = documents().map((page) => [page.key, addressOf(page)]);
const folders = [...withFigures, ...documented].map(([, path]) => path);
/** axe takes ten seconds for the longest one, which is made as the others are. */
const references = documented.filter(([key]) => key !== "api" || isThorough);

const kDesk = { viewport: { width: 1440, height: 900 }, colorScheme: "dark" };
const kPhone = {
  viewport: { width: 390, height: 800 },
  colorScheme: "light",
  hasTouch: true,
  isMobile: true,
};
/** The other way round, in long runs only. */
const kOthers = isThorough
  ? [
      { ...kDesk, colorScheme: "light" },
      { ...kPhone, colorScheme: "dark" },
    ]
  : [];

describeInBrowser("the site", (open, server) => {
  const visit = (path, options) => open({ path, ready: "figures", ...options });

  /** Expects that no rule of axe is broken and nothing too wide; saves a picture in long runs. */
  async function expectFit(page, key, { viewport, colorScheme }) {
    await page.evaluate(() => scrollTo(0, 0));
    await page.evaluate(axe);
    const violations = await page.evaluate(async () =>
      (await window.axe.run()).violations.map(
        ({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 120)).join(" | ")}`,
      ),
    );
    expect(violations).toEqual([]);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(wide).toBeLessThanOrEqual(0);
    if (!isThorough) return;
    mkdirSync(pictures, { recursive: true });
    const name = `site_${key}_${colorScheme}_${viewport.width}.png`;
    await page.screenshot({ path: pictures + name, fullPage: true });
  }

  test.each(withFigures)("%s: figures answer mouse and keyboard", async (key, path) => {
    const page = await visit(path, kDesk);
    await tryByMouseAndKeyboard(page);
    await expectFit(page, key, kDesk);
    expect(page.errors).toEqual([]);
    await closePage(page);
  });

  test.each(withFigures)("%s: figures answer a finger", async (key, path) => {
    const page = await visit(path, kPhone);
    await tryByFinger(page, touchInChromium);
    await expectFit(page, key, kPhone);
    expect(page.errors).toEqual([]);
    await closePage(page);
  });

  const pagesAndScreens = [
    ...references.map(([key, path], k) => [key, path, k % 2 === 0 ? kPhone : kDesk]),
    ...[...withFigures, ...references].flatMap((page) => kOthers.map((other) => [...page, other])),
  ];
  test.each(pagesAndScreens)("%s fits", async (key, path, screen) => {
    const page = await visit(path, screen);
    for (const name of await figuresOf(page)) await reach(page, name);
    await expectFit(page, key, screen);
    expect(page.errors).toEqual([]);
    await closePage(page);
  });

  test.each([
    390, 360, 320,
  ])("home, %i wide: both pictures and Examples without scrolling", async (width) => {
    const page = await visit("./", { ...kPhone, viewport: { width, height: 740 } });
    const bottoms = await page.evaluate(() =>
      [".bar [href$='examples/']", "[data-figure] .stage"].map(
        (part) => document.querySelector(part).getBoundingClientRect().bottom,
      ),
    );
    expect(Math.min(...bottoms)).toBeGreaterThan(0); // shown at all
    expect(Math.max(...bottoms)).toBeLessThan(740);
    expect(await page.locator("[data-figure] .said").first().textContent()).toMatch(
      /of the bubbles’ area/,
    );
    await closePage(page);
  });

  test("the first Tab reaches a link to the text, which skips the bar", async () => {
    const page = await visit("why/", kDesk);
    await page.keyboard.press("Tab");
    const focused = () =>
      page.evaluate(() => {
        const { top } = document.activeElement.getBoundingClientRect();
        return [document.activeElement.className || document.activeElement.tagName, top >= 0];
      });
    expect(await focused()).toEqual(["skip", true]);
    await page.keyboard.press("Enter");
    await page.keyboard.press("Tab");
    expect(await page.evaluate(() => document.activeElement.closest("main") !== null)).toBe(true);
    await closePage(page);
  });

  test("links lead to pages that are there, and to headings that are there", async () => {
    const ids = new Map();
    const wanted = new Map();
    for (const path of folders) {
      const address = new URL(path, server.url()).href;
      const html = await (await fetch(address)).text();
      ids.set(address, new Set([...html.matchAll(/ id="([^"]+)"/g)].map((match) => match[1])));
      for (const [, target] of html.matchAll(/ href="([^"]+)"/g)) {
        expect(target).not.toContain("/OWNER/");
        if (/^[a-z]+:/.test(target) || /^#?$/.test(target)) continue;
        const url = new URL(target, address);
        wanted.set(url.href, `${path} -> ${target}`);
      }
    }
    const broken = [];
    for (const [href, from] of wanted) {
      const url = new URL(href);
      const anchor = decodeURIComponent(url.hash.slice(1));
      url.hash = "";
      const known = ids.get(url.href);
      if (
        known ? anchor && !known.has(anchor) : (await fetch(url, { method: "HEAD" })).status >= 400
      )
        broken.push(from);
    }
    expect(broken).toEqual([]);
  });

  test("a page with figures has its first picture before any script", async () => {
    for (const [, path] of withFigures) {
      const html = await (await fetch(new URL(path, server.url()))).text();
      if (!html.includes("data-figure")) continue;
      expect([path, /<div class="stage"[^>]*><svg class="poster /.test(html)]).toEqual([
        path,
        true,
      ]);
    }
  });

  test("the security policy allows no inline script, and no page has one", async () => {
    for (const path of folders) {
      const html = await (await fetch(new URL(path, server.url()))).text();
      const policy = html.match(/content="(default-src[^"]*)"/)[1];
      expect(policy).toMatch(/script-src 'self' 'wasm-unsafe-eval';/);
      expect(
        [...html.matchAll(/<script\b([^>]*)>/g)].filter(([tag]) => !/ src="/.test(tag)),
      ).toEqual([]);
    }
  });
});

// Firefox is told its colours when it starts. One tab sees all pages, as a new one takes longer. In
// short runs each page is used on one screen, in turn the large and the small one.
describe.each(["dark", "light"])("%s", (colorScheme) => {
  const screens = [kDesk, kPhone, ...kOthers].filter((one) => one.colorScheme === colorScheme);
  const inTurn = ({ hasTouch }, k) => isThorough || (k % 2 === 0) === (hasTouch === true);
  const pagesAndScreens = withFigures.flatMap(([key, path], k) =>
    screens
      .filter((screen) => inTurn(screen, k))
      .map(({ viewport, hasTouch }) => [key, viewport.width, { path, viewport, hasTouch }]),
  );
  const define = (open, server) => {
    let page;
    beforeAll(async () => {
      page = await open({ path: "./", ready: "figures" });
    });
    test.each(pagesAndScreens)("%s, %s wide: figures answer", async (_key, _width, screen) => {
      await page.setViewport(screen.viewport);
      await page.goto(server.url() + screen.path);
      if (screen.hasTouch) await tryByFinger(page, touchInFirefox);
      else await tryByMouseAndKeyboard(page);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      expect(wide).toBeLessThanOrEqual(0);
      expect(page.errors).toEqual([]);
    });
  };
  describeInFirefox("the site in Firefox", define, { colorScheme });
});
