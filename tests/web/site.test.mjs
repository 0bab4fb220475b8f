// The pages of the site: each figure starts and answers mouse, touch and keyboard; nothing goes
// wrong, is wider than the window, or fails axe's rules; links lead somewhere; each page has its
// first picture before any script.
import { mkdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { fileURLToPath } from "node:url";
import { expect, test } from "@jest/globals";
import { documents } from "../../tools/site/documents.mjs";
import { kPages } from "../../tools/site/list.mjs";
import { closePage, describeInBrowser, describeInFirefox } from "./support/browser.mjs";
import { isThorough } from "./support/effort.mjs";

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
/** The same the other way round, in long runs only. */
const kOthers = isThorough
  ? [
      { ...kDesk, colorScheme: "light" },
      { ...kPhone, colorScheme: "dark" },
    ]
  : [];

/** Scrolls to a figure; resolves when it runs. */
async function reach(page, name) {
  await page.evaluate(
    (name) => document.querySelector(`[data-figure=${name}]`).scrollIntoView({ block: "center" }),
    name,
  );
  await page.waitForFunction(
    (name) => document.querySelector(`[data-figure=${name}]`).dataset.state,
    name,
    { polling: 100, timeout: 20_000 },
  );
}

const figuresOf = (page) =>
  page.evaluate(() =>
    Array.from(document.querySelectorAll("[data-figure]"), (figure) => figure.dataset.figure),
  );

/** What a reader of a figure gets: its text and its pixels. */
const seen = (page, name) =>
  page.evaluate(async (name) => {
    for (let k = 0; k < 2; k++) await new Promise(requestAnimationFrame);
    const figure = document.querySelector(`[data-figure=${name}]`);
    return figure.querySelector(".said").textContent + figure.querySelector("canvas").toDataURL();
  }, name);

/** What of a figure can be used: the first handle, the stage, the first slider, choice, button. */
const usable = async (page, name) => {
  const part = (selector) => page.$(`[data-figure=${name}] ${selector}`);
  return {
    handle: await part(".handle"),
    stage: await part(".stage[tabindex]"),
    slider: await part(".slider input"),
    choice: await part(".choice input:not(:checked)"),
    switch: await part(".switch input"),
    button: await part(".controls button:not(.reset):not(:disabled)"),
  };
};

const middleOf = async (element) => {
  const box = await element.boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
};

/** Each way to use a figure that it has, as [name, what to do]. */
async function uses(page, name) {
  const { handle, stage, slider, choice, switch: toggle, button } = await usable(page, name);
  const found = [];
  if (handle) {
    found.push([
      "drag",
      async () => {
        const { x, y } = await middleOf(handle);
        await page.mouse.move(x, y);
        await page.mouse.down();
        await page.mouse.move(x + 25, y + 15, { steps: 4 });
        await page.mouse.up();
      },
    ]);
    found.push([
      "arrow on a handle",
      async () => {
        await handle.focus();
        for (let k = 0; k < 3; k++) await page.keyboard.press("Shift+ArrowLeft");
      },
    ]);
  }
  if (stage) {
    found.push([
      "arrow at the pointer",
      async () => {
        await stage.focus();
        for (let k = 0; k < 3; k++) await page.keyboard.press("Shift+ArrowRight");
        await page.keyboard.press("Enter");
      },
    ]);
  }
  if (slider) {
    found.push([
      "arrow on a slider",
      async () => {
        await slider.focus();
        const isLow = await slider.evaluate(({ value, min, max }) => 2 * value < +min + +max);
        const key = isLow ? "ArrowRight" : "ArrowLeft"; // to where there is room
        for (let k = 0; k < 4; k++) await page.keyboard.press(key);
      },
    ]);
  }
  if (choice) found.push(["choice", () => choice.check({ force: true })]);
  if (toggle) found.push(["switch", () => toggle.click()]);
  if (button && found.length === 0) found.push(["button", () => button.click()]);
  return found;
}

describeInBrowser("the site", (open, server) => {
  const visit = (path, options) => open({ path, ready: "figures", ...options });

  /** No rule of axe is broken and nothing is too wide; in long runs, a picture to look at. */
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
    for (const name of await figuresOf(page)) {
      await reach(page, name);
      for (const [use, act] of await uses(page, name)) {
        const before = await seen(page, name);
        await act();
        await page.waitForTimeout(50);
        if ((await seen(page, name)) === before)
          throw new Error(`${key}, ${name}: ${use}: nothing`);
        await page.click(`[data-figure=${name}] .reset`);
      }
    }
    await expectFit(page, key, kDesk);
    expect(page.errors).toEqual([]);
    await closePage(page);
  });

  test.each(withFigures)("%s: figures answer a finger", async (key, path) => {
    const page = await visit(path, kPhone);
    const devtools = await page.context().newCDPSession(page);
    const touch = (type, ...touchPoints) =>
      devtools.send("Input.dispatchTouchEvent", { type, touchPoints });
    for (const name of await figuresOf(page)) {
      await reach(page, name);
      const { handle, stage } = await usable(page, name);
      const target = handle ?? stage;
      if (!target) continue;
      const before = await seen(page, name);
      const { x, y } = await middleOf(target);
      const [dx, dy] = handle ? [24, 14] : [40, 0];
      await touch("touchStart", { x, y });
      for (let k = 1; k <= 4; k++)
        await touch("touchMove", { x: x + (k * dx) / 4, y: y + (k * dy) / 4 });
      await touch("touchEnd");
      await page.waitForTimeout(50);
      if ((await seen(page, name)) === before) throw new Error(`${name}: a finger changes nothing`);
    }
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

describeInFirefox("the site in Firefox", (open) => {
  test.each(withFigures)("%s: figures start", async (_, path) => {
    const page = await open({ path, ready: "figures" });
    for (const name of await figuresOf(page)) {
      await page.evaluate(
        (name) =>
          document.querySelector(`[data-figure=${name}]`).scrollIntoView({ block: "center" }),
        name,
      );
      await page.waitForFunction(
        (name) => document.querySelector(`[data-figure=${name}]`).dataset.state === "running",
        { timeout: 20_000, polling: 100 },
        name,
      );
    }
    expect(page.errors).toEqual([]);
    await page.close();
  });
});
