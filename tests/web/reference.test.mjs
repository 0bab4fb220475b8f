// The reference's pages: each call has its place and a link beside the page, examples run, and the
// search finds words on all pages.
import { describe, expect, test } from "@jest/globals";
import { transform } from "esbuild";
import { documents } from "../../tools/site/documents.mjs";
import { programsByCode } from "../../tools/site/reference.mjs";
import { closePage, describeInBrowser } from "./support/browser.mjs";

const pages = documents().filter(({ side }) => side);
const programs = [...programsByCode().values()];

test("each example of the reference is a program of its own", async () => {
  expect(programs.length).toBeGreaterThan(150);
  for (const program of programs) {
    await transform(program, { format: "esm", target: "esnext" }); // throws on a syntax error
    expect(program).toMatch(/^import |^(\/\/.*\n)*import /m);
  }
  // The printed lines are those of the comments.
  const find = programs.find((program) => program.includes("4 from Seal Rock"));
  expect(find).toContain("const id = diagram.find(52, 30);\nconsole.log(id); // 0: 2 from");
  expect(find).toContain("console.log(islands[id].name);");
});

describeInBrowser("the reference", (open) => {
  const visit = (path, more) =>
    open({ path, ready: "figures", viewport: { width: 1300, height: 800 }, ...more });

  test("an old link leads to the call; the list beside the page marks what is read", async () => {
    const page = await visit("reference/api/#diagramknearest");
    await page.click("#diagramknearest a");
    await page.waitForURL(/\/reference\/api\/diagram\/#diagramknearest$/);
    const marked = page.locator('nav.side .calls [aria-current="true"]');
    await page.waitForFunction(() =>
      /kNearest$/.test(document.querySelector('.calls [aria-current="true"]')?.textContent ?? ""),
    );
    await page.evaluate(() => document.getElementById("diagramhull").scrollIntoView());
    await page.waitForFunction(
      () => document.querySelector('.calls [aria-current="true"]')?.textContent === "hull",
    );
    expect(await marked.count()).toBe(1);
    const isSeen = await marked.evaluate((link) => {
      const [own, box] = [link, link.closest("nav")].map((one) => one.getBoundingClientRect());
      return own.top >= box.top && own.bottom <= box.bottom;
    });
    expect(isSeen).toBe(true);
    expect(page.errors).toEqual([]);
    await closePage(page);
  });

  test("on a phone the list is closed, and opens", async () => {
    const page = await visit("reference/api/voronoi/", { viewport: { width: 360, height: 700 } });
    const link = page.locator('nav.side a[href="#voronoicellcircle"]');
    expect(await link.isVisible()).toBe(false);
    await page.click("nav.side summary");
    await link.click();
    await page.waitForURL(/#voronoicellcircle$/);
    const rows = await page.evaluate(
      () =>
        new Set(
          [...document.querySelectorAll(".bar nav > :not(.search, [href$='examples/'])")]
            .filter(({ offsetWidth }) => offsetWidth > 0)
            .map(({ offsetTop }) => offsetTop),
        ).size,
    );
    expect(rows).toBe(1);
    await closePage(page);
  });

  test("an example runs below its code, and can be changed", async () => {
    const page = await visit("reference/api/diagram/");
    const code = page.locator(".code", { hasText: "4 from Seal Rock" });
    await code.locator("button.run").click();
    const card = page.locator(".code:has-text('4 from Seal Rock') + .recipe");
    await page.waitForSelector('.recipe[data-state="done"]');
    expect(await card.locator(".printed").textContent()).toBe("0\nGreat Isle\n2\n-1\n");
    await card.locator("textarea").fill("console.log(6 * 7);");
    await card.locator("button.run").click();
    await page.waitForFunction(
      () => document.querySelector(".recipe .printed").textContent === "42\n",
    );
    expect(page.errors).toEqual([]);
    await closePage(page);
  });

  test("“nearest” finds the calls, the page that explains them, and the recipe", async () => {
    const page = await visit("reference/api/treemap/");
    await page.keyboard.press("/");
    await page.keyboard.type("nearest");
    await page.waitForSelector("dialog.search li");
    const found = await page.evaluate(() =>
      [...document.querySelectorAll("dialog.search a")].map((link) =>
        decodeURI(new URL(link.href).pathname + new URL(link.href).hash),
      ),
    );
    const ends = [
      "/reference/api/diagram/#diagramfind",
      "/reference/api/diagram/#diagramnearest",
      "/asking/",
      "/recipes/#i-want-to-hover-a-bubble-chart",
    ];
    for (const end of ends) expect(found.some((path) => path.endsWith(end))).toBe(true);
    await page.keyboard.press("ArrowDown");
    expect(await page.evaluate(() => document.activeElement.tagName)).toBe("A");
    await page.keyboard.press("ArrowUp");
    await page.fill("dialog.search input", "");
    await page.waitForFunction(() => document.querySelector("dialog.search li") === null);
    await page.keyboard.press("Escape");
    expect(await page.locator("dialog.search").isVisible()).toBe(false);
    expect(page.errors).toEqual([]);
    await closePage(page);
  });
});

describe("links", () => {
  test("of the reference lead to headings that are there", () => {
    const anchors = new Map(pages.map(({ folder, anchors: own }) => [folder, new Set(own)]));
    for (const { side, folder } of pages) {
      for (const [, anchor] of side.matchAll(/href="#([^"]+)"/g))
        expect([folder, anchor, anchors.get(folder).has(anchor)]).toEqual([folder, anchor, true]);
    }
  });
});
