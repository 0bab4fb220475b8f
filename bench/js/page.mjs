// Measures the page in Chromium: the time of frames while the pointer hovers, zooms, pans and
// drags, at 10 000, 100 000 and 1 000 000 circles, and while 10 000 move, beside a page that draws
// the centres with d3-delaunay in every frame; and the time until a set is shown. Then measures the
// globe of web/examples with its 1 500 cities, while the pointer hovers and turns it.
//
// It needs dist/ (npm run build) and Chromium (CHROMIUM, or the installed one).
import { readFileSync } from "node:fs";
import { chromium } from "playwright-core";
import { buildSite } from "../../tools/build_site.mjs";
import { serve } from "../../tools/serve.mjs";
import { findChromium } from "../../tools/toolchain/browser.mjs";

const kArguments = ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"];
const kViewport = { width: 1280, height: 800 };
const kRest = 1500; // ms
const kSteps = 60;
const kLongest = 10_000; // ms of a movement
const kMostDrifting = 10_000; // circles
const kDrift = 4000; // ms
const kTurns = 240; // frames
const kSizes = [10_000, 100_000, 1_000_000];

/** The other page, which draws all cells and centres in each frame. */
const otherPage = new URL("d3_page.html", import.meta.url);

/** Times between frames while something is done, in ms. */
async function framesOf(page, act) {
  await page.evaluate(() => {
    window.frames_ = [];
    window.isCounting = true;
    let last = performance.now();
    requestAnimationFrame(function frame(now) {
      window.frames_.push(now - last);
      last = now;
      if (window.isCounting) requestAnimationFrame(frame);
    });
  });
  await act();
  return page.evaluate(() => {
    window.isCounting = false;
    return window.frames_.slice(1).sort((a, b) => a - b);
  });
}

const at = (sorted, share) =>
  sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
const summary = (sorted) =>
  [0.5, 0.95, 1].map((share) => at(sorted, share).toFixed(0).padStart(6)).join("");

/** Does the steps of a movement until kLongest ms have passed: a frame can take seconds. */
async function repeat(steps, act) {
  const start = performance.now();
  for (let k = 0; k < steps && performance.now() - start < kLongest; k++) await act(k);
}

/** Measures either page with equal movements. */
async function measure(page, size) {
  const { mouse } = page;
  const rows = {};
  const rest = () => page.waitForTimeout(kRest);
  rows.still = await framesOf(page, () => page.waitForTimeout(600));
  rows.hover = await framesOf(page, async () => {
    await repeat(kSteps, (k) => mouse.move(300 + 8 * k, 250 + 4 * k));
  });
  rows["zoom in"] = await framesOf(page, async () => {
    await repeat(kSteps / 2, () => mouse.wheel(0, -60));
  });
  await rest();
  rows.pan = await framesOf(page, async () => {
    await mouse.down();
    await repeat(kSteps, (k) => mouse.move(700 - 6 * k, 480 - 3 * k));
    await mouse.up();
  });
  await rest();
  rows["zoom out"] = await framesOf(page, async () => {
    await repeat(kSteps / 2, () => mouse.wheel(0, 60));
  });
  await rest();
  if (size <= kMostDrifting)
    rows.drift = await framesOf(page, async () => {
      await page.evaluate(() => window.drift());
      await page.waitForTimeout(kDrift);
      await page.evaluate(() => window.drift());
    });
  return rows;
}

async function open(browser, url, isOther) {
  const page = await browser.newPage({ viewport: kViewport, reducedMotion: "reduce" });
  page.setDefaultTimeout(300_000);
  page.on("pageerror", (error) => console.error(String(error)));
  await page.route("**/web/other.html", (route) =>
    route.fulfill({ contentType: "text/html", body: readFileSync(otherPage) }),
  );
  await page.goto(url + (isOther ? "other.html" : "playground/"));
  await page.waitForFunction(() => window.app);
  if (!isOther)
    await page.evaluate(() => {
      window.drift = () => document.getElementById("drift").click();
    });
  return page;
}

/** Loads random circles; times from the request on. */
const load = (page, count) =>
  page.evaluate(async (n) => {
    const start = performance.now();
    let replaced = 0;
    app.model.addEventListener("change", ({ detail }) => {
      if (detail.isSet) replaced = performance.now();
    });
    await app.navigation.load("random", { n: String(n), hidden: "5", seed: "1" });
    const loaded = performance.now();
    await new Promise((resolve) => {
      const wait = () => (app.painter.isDone ? resolve(0) : setTimeout(wait, 5));
      wait();
    });
    return {
      all: performance.now() - start,
      build: app.sites.buildTime,
      shown: performance.now() - Math.min(replaced, loaded),
    };
  }, count);

/** Measures the globe, which is turned in each frame, too: events come less often. */
async function measureGlobe(browser, url) {
  const page = await browser.newPage({ viewport: kViewport });
  await page.goto(`${url}examples/globe.html`);
  await page.waitForFunction(() => window.example);
  const { mouse } = page;
  const rows = {};
  rows.hover = await framesOf(page, async () => {
    await repeat(kSteps, (k) => mouse.move(450 + 5 * k, 250 + 4 * k));
  });
  rows.drag = await framesOf(page, async () => {
    await mouse.down();
    await repeat(kSteps, (k) => mouse.move(750 - 5 * k, 490 - 3 * k));
    await mouse.up();
  });
  await page.waitForTimeout(kRest);
  rows.turn = await framesOf(page, () =>
    page.evaluate(async (frames) => {
      for (let k = 0; k < frames; k++) {
        example.turn(1.5, Math.sin(k / 20));
        await new Promise(requestAnimationFrame);
      }
    }, kTurns),
  );
  await page.close();
  return rows;
}

await buildSite();
const server = await serve(0);
const executablePath = findChromium();
const browser = await chromium.launch({ executablePath, args: kArguments });
try {
  console.log("ms between frames: median, 95 %, longest");
  for (const size of kSizes) {
    const page = await open(browser, server.url, false);
    const times = await load(page, size);
    const said = Object.entries(times).map(([name, ms]) => `${name} ${ms.toFixed(0)} ms`);
    console.log(`\n${size} circles: ${said.join(", ")}`);
    for (const [name, frames] of Object.entries(await measure(page, size)))
      console.log(`  page         ${name.padEnd(10)}${summary(frames)}`);
    await page.close();
    const other = await open(browser, server.url, true);
    const { build } = await other.evaluate((n) => window.make(n), size);
    console.log(`  d3-delaunay  built and drawn in ${build.toFixed(0)} ms`);
    for (const [name, frames] of Object.entries(await measure(other, size)))
      console.log(`  d3-delaunay  ${name.padEnd(10)}${summary(frames)}`);
    await other.close();
  }
  console.log("\nthe globe");
  for (const [name, frames] of Object.entries(await measureGlobe(browser, server.url)))
    console.log(`  page         ${name.padEnd(10)}${summary(frames)}`);
} finally {
  await browser.close();
  await server.close();
}
