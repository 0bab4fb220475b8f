// How long it takes until a page of the site shows its first picture, on a throttled line, and
// until its first figure can be used. The first picture is in the HTML and comes with the first
// paint.
//
//   node bench/js/first_picture.mjs
//
// It needs dist/ (npm run build) and Chromium (CHROMIUM, or what is installed).
import { chromium } from "playwright-core";
import { buildSite } from "../../tools/build_site.mjs";
import { serve } from "../../tools/serve.mjs";
import { kPages } from "../../tools/site/list.mjs";
import { findChromium } from "../../tools/toolchain/browser.mjs";

const kRuns = 3;
/** As Chromium's developer tools have them: bytes per second, ms, and how slow the processor is. */
const kLines = {
  "fast 4G": { download: 1_012_500, latency: 165, slowdown: 1 },
  "slow 4G, slow processor": { download: 180_000, latency: 562.5, slowdown: 4 },
};
const kPaths = [...kPages.map(({ folder }) => (folder ? `${folder}/` : "")), "playground/"];

async function visit(browser, url, { download, latency, slowdown }) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  const page = await context.newPage();
  const devtools = await context.newCDPSession(page);
  await devtools.send("Network.enable");
  await devtools.send("Network.emulateNetworkConditions", {
    offline: false,
    latency,
    downloadThroughput: download,
    uploadThroughput: download / 2,
  });
  await devtools.send("Emulation.setCPUThrottlingRate", { rate: slowdown });
  await page.goto(url);
  await page.waitForFunction(
    () => window.app ?? document.querySelector("figure[data-state], .recipe") ?? window.figures,
    null,
    { polling: 20, timeout: 60_000 },
  );
  const usable = await page.evaluate(() => performance.now());
  const picture = await page.evaluate(
    () => performance.getEntriesByName("first-contentful-paint")[0]?.startTime,
  );
  await context.close();
  return { picture, usable };
}

const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];

await buildSite();
const server = await serve(0, { isCompressing: true });
const browser = await chromium.launch({
  executablePath: findChromium(),
  args: ["--no-sandbox", "--disable-gpu"],
});
for (const [name, line] of Object.entries(kLines)) {
  console.log(`${name}: first picture, usable (ms, median of ${kRuns})`);
  for (const path of kPaths) {
    const runs = [];
    for (let k = 0; k < kRuns; k++) runs.push(await visit(browser, server.url + path, line));
    const [picture, usable] = ["picture", "usable"].map((key) =>
      median(runs.map((run) => run[key])),
    );
    console.log(
      `  /${path}`.padEnd(18),
      picture.toFixed(0).padStart(6),
      usable.toFixed(0).padStart(6),
    );
  }
}
await browser.close();
await server.close();
