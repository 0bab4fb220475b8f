// The cards of the page "Recipes": each program runs and shows something, readers can change it,
// and mistakes are told. Programs run in a sandbox, and the page itself runs no inline script.
import { expect, test } from "@jest/globals";
import { closePage, describeInBrowser, describeInFirefox } from "./support/browser.mjs";
import { isThorough } from "../support/effort.mjs";

const kRecipes = { path: "recipes/", ready: "figures" };
const kHasEnded = "[data-state=done], [data-state=failed]";

/** The card below a heading that has this text; it is scrolled to, so that it runs. */
async function cardOf(page, title) {
  const card = page.locator(".recipe", { has: page.getByLabel(`Program: ${title}`) });
  await card.scrollIntoViewIfNeeded();
  await endOf(card);
  return card;
}

const endOf = (card) => card.and(card.page().locator(kHasEnded)).waitFor();

/** Counts what the sandbox of a card shows: shapes, and points of a canvas. */
const shownIn = (card) =>
  card
    .frameLocator("iframe")
    .locator("body")
    .evaluate((body) => {
      const boxes = [...body.querySelectorAll("circle, path, line, canvas")].map((shape) =>
        shape.getBoundingClientRect(),
      );
      return boxes.filter(({ width, height }) => width + height > 4).length;
    });

async function runWith(card, program) {
  await card.locator("textarea").fill(program);
  await card.locator("textarea").press("Control+Enter");
  await endOf(card);
}

describeInBrowser("recipe cards", (open) => {
  const eachSize = isThorough ? [1280, 390] : [390];
  test.each(
    eachSize,
  )("every card runs without error and shows a picture, %d wide", async (width) => {
    const page = await open({ ...kRecipes, viewport: { width, height: 800 } });
    const cards = await page.locator(".recipe").all();
    expect(cards.length).toBe(11);
    for (const card of cards) {
      await card.scrollIntoViewIfNeeded();
      await endOf(card);
      expect([await card.locator(".failed").textContent(), await shownIn(card)]).toEqual([
        "",
        expect.any(Number),
      ]);
      expect(await shownIn(card)).toBeGreaterThan(0);
      const frame = await card.locator("iframe").boundingBox();
      expect(frame.height).toBeGreaterThan(150);
    }
    const isTooWide = () => document.documentElement.scrollWidth > innerWidth;
    expect(await page.evaluate(isTooWide)).toBe(false);
    expect(page.errors).toEqual([]);
    await closePage(page);
  });

  test("a changed program runs, and Reset brings back the first one", async () => {
    const page = await open(kRecipes);
    const card = await cardOf(page, "I want the largest empty circle");
    const printed = card.locator(".printed");
    const first = await printed.textContent();
    expect(first).toMatch(/radius \d/);
    await runWith(
      card,
      `import { Diagram } from "apollonius-diagram";
      console.log("nearest", Diagram.from([[0, 0, 5], [9, 0, 1]]).find(6.5, 0));`,
    );
    expect(await printed.textContent()).toBe("nearest 0\n");
    await card.getByRole("button", { name: "Reset" }).click();
    await endOf(card);
    expect(await printed.textContent()).toBe(first);
    expect(page.errors).toEqual([]);
    await closePage(page);
  });

  test("treemaps and spheres can be imported, too", async () => {
    const page = await open(kRecipes);
    const card = await cardOf(page, "I want GeoJSON");
    await runWith(
      card,
      `import { SphericalDiagram } from "apollonius-diagram/sphere";
      import { treemap } from "apollonius-diagram/treemap";
      console.log(SphericalDiagram.from([[0, 0, 0]]).size, typeof treemap());`,
    );
    expect(await card.locator(".printed").textContent()).toBe("1 function\n");
    await closePage(page);
  });

  test("mistakes are shown with their line, in red, until the next run", async () => {
    const page = await open(kRecipes);
    const card = await cardOf(page, "I want cells as SVG paths");
    const failed = card.locator(".failed");
    await runWith(card, 'console.log("here");\nnowhere();');
    expect(await failed.textContent()).toMatch(/^Line 2: .*nowhere is not defined/);
    expect(await card.locator(".printed").textContent()).toBe("here\n");
    const colors = await failed.evaluate((element) => {
      const wrong = getComputedStyle(document.documentElement).getPropertyValue("--wrong");
      const probe = Object.assign(document.createElement("i"), { style: `color: ${wrong}` });
      element.append(probe);
      const found = [getComputedStyle(element).color, getComputedStyle(probe).color];
      probe.remove();
      return found;
    });
    expect(colors[0]).toBe(colors[1]);
    await runWith(card, "const = 3;");
    expect(await failed.textContent()).toMatch(/^Line 1: .*SyntaxError/);
    const wrong = 'import { Diagram } from "apollonius-diagram";\nnew Diagram([0, 0, NaN]);';
    await runWith(card, wrong); // thrown in a line of the library
    expect(await failed.textContent()).toMatch(/^Line 2: ApolloniusError: /);
    await runWith(card, 'import { scaleLinear } from "d3-scale";');
    expect(await failed.textContent()).toMatch(/d3-scale/);
    await runWith(card, 'await Promise.reject(new Error("too late"));');
    await failed.filter({ hasText: "too late" }).waitFor();
    await card.getByRole("button", { name: "Reset" }).click();
    await endOf(card);
    expect(await failed.isVisible()).toBe(false);
    await closePage(page);
  });

  test("callbacks without an end are stopped; Run and Reset answer afterwards", async () => {
    const page = await open({ ...kRecipes, isAlone: true });
    const card = await cardOf(page, "I want areas by value");
    const failed = card.locator(".failed");
    await runWith(
      card,
      "let n = 0;\nArray.from({ length: 1e6 }).forEach((_, k, all) => all.forEach(() => n++));",
    );
    expect(await failed.textContent()).toMatch(/^Line 2: Error: the program was stopped/);
    await runWith(card, "console.log([3, 1, 2].map((x) => ({ x })).map(({ x }) => x).join());");
    expect(await card.locator(".printed").textContent()).toBe("3,1,2\n");
    await card.getByRole("button", { name: "Reset" }).click();
    await endOf(card);
    expect(await failed.isVisible()).toBe(false);
    await closePage(page);
  });

  test("loops without an end are stopped, those with pauses are not", async () => {
    const page = await open({ ...kRecipes, isAlone: true });
    const card = await cardOf(page, "I want areas by value");
    const failed = card.locator(".failed");
    await runWith(
      card,
      "let n = 0;\nwhile (true)\n  for (let k = 0; k < 9; ++k) try { n++; } catch {}",
    );
    expect(await failed.textContent()).toMatch(/^Line [23]: Error: the program was stopped/);
    await runWith(card, "let n = 0;\ndo await n++;\nwhile (n >= 0);");
    await failed.filter({ hasText: /^Line 2: Error: the program was stopped/ }).waitFor();
    await runWith(
      card,
      `const pause = () => new Promise((go) => setTimeout(go, 10));
      const start = performance.now();
      rounds: while (performance.now() - start < 6000)
        for (const k of [1, 2]) if (k === 2) continue rounds; else await pause();
      console.log("ended");`,
    );
    await card.locator(".printed").filter({ hasText: "ended" }).waitFor();
    expect(await failed.isVisible()).toBe(false);
    await closePage(page);
  });

  test("the package is asked for once more if the network drops it", async () => {
    const prepare = async (page) => {
      let isFirst = true;
      await page.route("**/lib/apollonius-diagram/core.js", (route) => {
        if (!isFirst) return route.continue();
        isFirst = false;
        return route.abort("addressunreachable");
      });
    };
    const page = await open({ ...kRecipes, prepare });
    await cardOf(page, "I want areas by value");
    expect(await page.locator(".recipe[data-state=failed]").count()).toBe(0);
    expect(page.errors.join()).toMatch("ADDRESS_UNREACHABLE");
    await closePage(page);
  });

  test("programs reach neither page nor network; the page runs none inline", async () => {
    const page = await open(kRecipes);
    const card = await cardOf(page, "I want areas by value");
    await runWith(card, "console.log(parent.document.title);");
    expect(await card.locator(".failed").textContent()).toMatch(/SecurityError|cross-origin/);
    await runWith(card, 'await fetch("../index.html");');
    await card.locator(".failed").filter({ hasText: "fetch" }).waitFor();
    const hasRun = await page.evaluate(() => {
      const script = document.createElement("script");
      script.textContent = "window.hasRun = true;";
      document.head.append(script);
      return window.hasRun === true;
    });
    expect(hasRun).toBe(false);
    const policy = await page.getAttribute("meta[http-equiv=Content-Security-Policy]", "content");
    expect(policy).not.toMatch(/unsafe-inline|unsafe-eval(?<!wasm-unsafe-eval)|blob:/);
    await closePage(page);
  });
});

describeInFirefox("recipe cards in Firefox", (open) => {
  test("the first card runs, and a loop without an end is stopped", async () => {
    const page = await open({ path: "recipes/", ready: null });
    await page.$eval(".recipe", (card) => card.scrollIntoView());
    await page.waitForSelector(".recipe[data-state=done]");
    await page.$eval(".recipe textarea", (text) => {
      text.value = "for (;;);";
    });
    await page.click(".recipe .run");
    await page.waitForSelector(".recipe[data-state=failed]");
    expect(await page.$eval(".recipe .failed", (said) => said.textContent)).toMatch(
      "Line 1: Error: the program was stopped",
    );
    await page.close();
  });
});
