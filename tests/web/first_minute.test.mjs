// The first page's lines about starting work as they are written, with the packed files in place of
// those at their addresses.
import { readFileSync } from "node:fs";
import path from "node:path";
import { describe, expect, test } from "@jest/globals";
import { root } from "../../tools/toolchain/folders.mjs";
import { closePage, describeInBrowser } from "./support/browser.mjs";

const home = readFileSync(path.join(root, "web/pages/home.md"), "utf8");
const blocksOf = (language) =>
  [...home.matchAll(new RegExp(`^\`\`\`${language}\\n([\\s\\S]*?)^\`\`\``, "gm"))].map(
    ([, code]) => code,
  );

describe("the modules", () => {
  test.each(
    blocksOf("js").map((code, k) => [k, code]),
  )("%i give what they say", async (_, code) => {
    const entry = path.join(root, "dist/esm/index.js");
    const values = [];
    const program = code
      .replace(/import \{ Diagram \} from ".*";/, "")
      .replace(/^(\S.*); \/\/ (\d+).*$/gm, "said.push([$1, $2]);")
      .replace("const path =", "said.path =");
    const { Diagram } = await import(entry);
    new Function("Diagram", "said", program)(Diagram, values);
    expect(values.length).toBeGreaterThan(0);
    for (const [value, said] of values) expect(value).toBe(said);
    if (code.includes("const path")) expect(values.path).toMatch(/^M/);
  });
});

describeInBrowser("from the package's address", (open) => {
  /** Opens HTML as a page of another site, with the packed files at their address. */
  async function show(page, html) {
    await page.route("https://cdn.jsdelivr.net/npm/apollonius-diagram**", (route) => {
      const [, file] = route
        .request()
        .url()
        .split(/\/npm\/apollonius-diagram(?:@[\d.]+)?/);
      route.fulfill({
        path: path.join(root, file || "dist/apollonius.js"),
        contentType: "text/javascript",
        headers: { "access-control-allow-origin": "*" },
      });
    });
    await page.route("https://example.org/", (route) =>
      route.fulfill({ body: html, contentType: "text/html" }),
    );
    await page.goto("https://example.org/");
  }

  test("the script works", async () => {
    const [html] = blocksOf("html");
    const page = await open({ path: "scale/", ready: "figures" });
    await show(page, `<!doctype html><body>${html}`);
    await page.waitForFunction(() => document.body.textContent.trim().endsWith("0"));
    await closePage(page);
  });

  test("a recipe that is copied as one HTML file works by itself", async () => {
    const page = await open({ path: "recipes/", ready: "figures" });
    await page.evaluate(() => {
      navigator.clipboard.writeText = async (text) => {
        window.copied = text;
      };
    });
    const recipe = page.locator(".recipe", { hasText: "airports" });
    await recipe.locator(".copy-page").click();
    const html = await (await page.waitForFunction(() => window.copied)).jsonValue();
    const { version } = JSON.parse(readFileSync(path.join(root, "package.json"), "utf8"));
    expect(html).toContain(`/npm/apollonius-diagram@${version}/dist/esm/index.js`);
    await show(page, html);
    const area = page.locator("svg .area").first();
    const lookOf = (one) => one.evaluate((shape) => getComputedStyle(shape).fill);
    await area.waitFor();
    expect(await page.title()).toMatch(/^I want/);
    expect(await lookOf(area)).toMatch(/^rgb/);
    expect(await lookOf(area)).not.toBe("rgb(0, 0, 0)");
    expect(page.errors).toEqual([]);
    await closePage(page);
  });
});
