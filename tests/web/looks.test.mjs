// Everybody can use the page: names, roles and contrasts by axe's rules, in both themes and on a
// phone; targets of a finger's size; contrast of the drawing; forced colours; no script except the
// page's own.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { describe, expect, test } from "@jest/globals";
import { closePage, describeInBrowser, painted, settled, show } from "./support/browser.mjs";
import { isThorough } from "../support/effort.mjs";
import { serve } from "../../tools/serve.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const kPhone = { viewport: { width: 390, height: 780 }, hasTouch: true, isMobile: true };
const kSideways = { viewport: { width: 780, height: 390 }, hasTouch: true, isMobile: true };

/** axe's complaints about the page as it is. */
async function complaints(page) {
  await page.evaluate(axe); // by the debugger's way, which the policy does not concern
  const { violations } = await page.evaluate(() => axe.run());
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map((n) => n.target).join(", ")}`);
}

/** Relative luminance of "rgb(…)" or "#…", as WCAG has it. */
function luminance([r, g, b]) {
  const linear = [r, g, b].map((c) => {
    const share = c / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
}

const contrast = (a, b) => {
  const [light, dark] = [luminance(a), luminance(b)].sort((x, y) => y - x);
  return (light + 0.05) / (dark + 0.05);
};

describeInBrowser("looks", (open) => {
  describe.each(["light", "dark"])("%s", (colorScheme) => {
    const screens = [
      ["desktop", {}],
      ["phone", kPhone],
    ];
    // Names and roles do not depend on the colours: each screen in one of them will do.
    const chosen = isThorough ? screens : [screens[colorScheme === "light" ? 0 : 1]];
    const title = "axe finds nothing on a %s, with menus, card and dialogs open";
    test.each(chosen)(title, async (_, kind) => {
      const page = await open({ colorScheme, ...kind });
      expect(await complaints(page)).toEqual([]);
      await page.evaluate(() => app.selection.set([4]));
      for (const id of ["open-sets", "open-show", "open-share"]) {
        await page.click(`#${id}`);
        await settled(page);
        expect(await complaints(page)).toEqual([]);
        await page.keyboard.press("Escape");
      }
      await page.evaluate(() => document.getElementById("open-code").click());
      await settled(page);
      expect(await complaints(page)).toEqual([]);
      expect(page.errors).toEqual([]);
      await closePage(page);
    });

    test("cell lines have a contrast of 3 on paper, land and sea", async () => {
      const page = await open({ colorScheme });
      const colors = await page.evaluate(() => {
        const context = new OffscreenCanvas(1, 1).getContext("2d");
        const bytes = (name) => {
          context.clearRect(0, 0, 1, 1);
          context.fillStyle = app.painter.theme[name];
          context.fillRect(0, 0, 1, 1);
          return [...context.getImageData(0, 0, 1, 1).data.slice(0, 3)];
        };
        return Object.fromEntries(
          ["paper", "land", "sea", "cell", "site", "hidden", "accent", "selected"].map((name) => [
            name,
            bytes(name),
          ]),
        );
      });
      for (const line of ["cell", "site", "hidden", "accent", "selected"])
        for (const ground of ["paper", "land", "sea"])
          expect([line, ground, contrast(colors[line], colors[ground]) >= 3]).toEqual([
            line,
            ground,
            true,
          ]);
      await closePage(page);
    });
  });

  test.each([
    ["upright", kPhone],
    ["sideways", kSideways],
  ])("phone, %s: everything can be hit, nothing lies over another", async (_, kind) => {
    const page = await open(kind);
    const targets = await page.$$eval("button, a, input, summary", (all) =>
      all
        .filter((target) => target.checkVisibility() && !target.closest("[popover], dialog"))
        .map((target) => {
          const box = (target.closest("label") ?? target).getBoundingClientRect();
          return { id: target.id || target.textContent, ...box.toJSON() };
        }),
    );
    const seen = targets.filter(({ top, bottom, left, right }) => {
      return bottom > 0 && right > 0 && top < 1000 && left < 1000;
    });
    const tools = seen.filter(({ id }) => id.startsWith("tool-"));
    expect(tools.length).toBe(7);
    for (const { width, height } of tools) {
      expect(width).toBeGreaterThanOrEqual(44);
      expect(height).toBeGreaterThanOrEqual(44);
    }
    const [phoneWidth] = [kind.viewport.width];
    for (const { left, right } of tools) {
      expect(left).toBeGreaterThanOrEqual(0);
      expect(right).toBeLessThanOrEqual(phoneWidth);
    }
    await closePage(page);
  });

  test.each([
    ["upright", kPhone],
    ["sideways", kSideways],
  ])("phone, %s: what is selected comes out from under the open sheet", async (_, kind) => {
    const page = await open({ ...kind, path: "#set=random" });
    const { width, height } = kind.viewport;
    const selected = () =>
      page.evaluate(() => {
        const { x, y } = app.sites.site(app.selection.last);
        return [app.view.toScreenX(x), app.view.toScreenY(y)];
      });
    await page.evaluate(
      ([x, y]) => app.selection.set([app.diagram.find(app.view.toWorldX(x), app.view.toWorldY(y))]),
      [width / 4, height * 0.7],
    );
    const at = await selected();
    await page.touchscreen.tap(...at);
    await page.tap("#grip");
    const isUnder = ([x, y]) =>
      page.evaluate(([x, y]) => document.elementFromPoint(x, y).closest(".sheet") !== null, [x, y]);
    await page.waitForFunction(() => document.getElementById("sheet").clientHeight > 200);
    expect(await isUnder(at)).toBe(true);
    await page.waitForFunction(() => {
      const { x, y } = app.sites.site(app.selection.last);
      const [px, py] = [app.view.toScreenX(x), app.view.toScreenY(y)];
      return document.elementFromPoint(px, py).id === "overlay";
    });
    expect(await isUnder(await selected())).toBe(false);
    expect(await page.evaluate(() => app.pointer.hover.id === app.selection.last)).toBe(true);
    await closePage(page);
  });

  test("phone: the sheet opens and closes, with the card in it", async () => {
    const page = await open(kPhone);
    const height = () => page.$eval("#sheet", (sheet) => sheet.getBoundingClientRect().height);
    const closed = await height();
    await page.evaluate(() => app.selection.set([4]));
    await page.tap("#grip");
    await page.waitForFunction(
      (closed) => document.getElementById("sheet").getBoundingClientRect().height > closed + 80,
      closed,
    );
    expect(await page.isVisible("#card-delete")).toBe(true);
    await page.tap("#card-delete");
    expect(await page.evaluate(() => app.diagram.size)).toBe(34);
    await page.tap("#grip");
    await page.waitForFunction(
      (closed) => document.getElementById("sheet").getBoundingClientRect().height <= closed + 1,
      closed,
    );
    await closePage(page);
  });

  test("what the counts say never overlaps, whatever the numbers", async () => {
    const page = await open({ viewport: { width: 800, height: 600 } });
    await page.evaluate(() => {
      document.getElementById("count-all").textContent = "1\u202f000\u202f000";
      document.getElementById("count-hidden").textContent = "999\u202f999";
      document.getElementById("timing").textContent = "built in 8.3 s, nearest in 0.7 µs";
    });
    const boxes = await page.evaluate(() =>
      ["status", "install", "tools", "intro"].map((id) =>
        document.getElementById(id).getBoundingClientRect().toJSON(),
      ),
    );
    for (const a of boxes)
      for (const b of boxes)
        if (a !== b)
          expect(
            a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top,
          ).toBe(true);
    await closePage(page);
  });

  test("forced colours: the diagram is drawn in the system's", async () => {
    const page = await open({ forcedColors: "active" });
    expect(await painted(page, "lines")).toBeGreaterThan(3000);
    expect(await painted(page, "circles")).toBeGreaterThan(1000);
    // On a ground of the page's own choice the browser would put text on another one.
    const pressed = ["#open-share", "#tool-select"];
    for (const selector of pressed) {
      const style = await page.$eval(selector, (node) => {
        const { forcedColorAdjust, color, backgroundColor } = getComputedStyle(node);
        const bytes = (value) => value.match(/\d+/g).slice(0, 3).map(Number);
        return { forcedColorAdjust, color: bytes(color), ground: bytes(backgroundColor) };
      });
      expect([selector, style.forcedColorAdjust]).toEqual([selector, "none"]);
      expect(contrast(style.color, style.ground)).toBeGreaterThan(4.5);
    }
    expect(page.errors).toEqual([]);
    await closePage(page);
  });

  test("works below another path, and without a network once it is loaded", async () => {
    const server = await serve(0); // a new origin: nothing of it is in a cache
    const page = await open({ site: server.url });
    await page.evaluate(() => app.whenFetched);
    await page.context().setOffline(true);
    await show(page, "nesting");
    await show(page, "cities");
    // One worker is there, and no way to another: it is free again when a building is given up.
    const givenUp = page.evaluate(() => app.navigation.load("random", { n: "500000" }));
    await page.waitForFunction(() => {
      if (!(document.getElementById("progress-bar").value > 0.05)) return false;
      document.getElementById("progress-cancel").click(); // a mouse may come after the end
      return true;
    });
    await givenUp;
    for (const n of ["100001", "100002"]) await show(page, "random", { n, hidden: "5" });
    expect(await page.evaluate(() => app.diagram.size)).toBe(100_002);
    await page.click("#tool-undo");
    await page.click("#tool-undo");
    await page.click("#open-code");
    await page.keyboard.press("Escape");
    // The tab's icon is asked for again and again.
    expect(page.errors.filter((error) => !/icon[\w-]*\.svg|DISCONNECTED/.test(error))).toEqual([]);
    await closePage(page);
    await server.close();
    const html = readFileSync(new URL("../../web/playground/index.html", import.meta.url), "utf8");
    expect(html).not.toMatch(/(?:href|src)="\//); // nothing from the root of a server
  });
});
