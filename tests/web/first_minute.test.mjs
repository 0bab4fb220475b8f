// What the first page says about starting works as it is written, with the packed files in place of
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

describeInBrowser("the script", (open) => {
  test("works from its address", async () => {
    const [html] = blocksOf("html");
    const page = await open({ path: "scale/", ready: "figures" });
    await page.route("https://cdn.jsdelivr.net/**", (route) =>
      route.fulfill({
        path: path.join(root, "dist/apollonius.js"),
        contentType: "text/javascript",
      }),
    );
    await page.route("https://example.org/", (route) =>
      route.fulfill({ body: `<!doctype html><body>${html}`, contentType: "text/html" }),
    );
    await page.goto("https://example.org/");
    await page.waitForFunction(() => document.body.textContent.trim().endsWith("0"));
    await closePage(page);
  });
});
