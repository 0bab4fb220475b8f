// Circles in and out: presets, text, files, the page's address.
import { readFileSync } from "node:fs";
import { describe, expect, test } from "@jest/globals";
import {
  circlesOf,
  closePage,
  describeInBrowser,
  forEachPage,
  settled,
  show,
  showCircles,
  stateOf,
} from "./support/browser.mjs";

const kThree = [
  [1, 2, 3],
  [10, 20, 4.5],
  [-7, 1e3, 0],
];

describeInBrowser("data", (open) => {
  let page;
  forEachPage(open, (opened) => {
    page = opened;
  });

  const numbers = async () => (await circlesOf(page)).map(([, x, y, r]) => [x, y, r]);

  test("every preset is there, is drawn, and says what it shows", async () => {
    const keys = await page.$$eval("#presets button", (buttons) =>
      buttons.map((button) => button.dataset.set),
    );
    expect(keys.length).toBeGreaterThan(10);
    for (const key of keys) {
      await page.click("#open-sets");
      await page.click(`#presets [data-set=${key}]`);
      await page.waitForFunction((key) => app.sites.info.key === key, key);
      await settled(page);
      expect((await stateOf(page)).broken).toBeNull();
      expect((await page.textContent("#about")).length).toBeGreaterThan(20);
    }
    // Back through all of them.
    for (let k = 0; k < keys.length; k++) await page.click("#tool-undo");
    expect(await page.evaluate(() => app.sites.info.key)).toBe("opening");
  });

  test("the cities on the globe are a page of the examples", async () => {
    await page.click("#open-sets");
    await page.click("#presets a");
    await page.waitForFunction(() => window.example?.diagram.size === 1500);
    expect(await page.textContent("h1")).toBe("Cities on the globe");
    await page.click("text=← Playground");
    await page.waitForFunction(() => window.app);
  });

  test("what presets promise: one vertex, contacts, hidden circles", async () => {
    await show(page, "cocircular");
    const corners = await page.evaluate(() => {
      const { xy: coordinates, clearance } = app.diagram.vertices();
      return Array.from(clearance, (r, k) => [coordinates[2 * k], coordinates[2 * k + 1], r]);
    });
    const inTheMiddle = corners.filter(([x, y]) => Math.hypot(x, y) < 1e-6);
    expect(inTheMiddle).toHaveLength(14); // two fewer than the sixteen sites
    await show(page, "nesting");
    expect((await stateOf(page)).hidden).toBe(3);
    for (const [key, touching] of [
      ["chain", 25],
      ["gasket", 200],
    ]) {
      await show(page, key);
      const circles = await numbers();
      const gaps = circles.flatMap(([x, y, r], k) =>
        circles.slice(k + 1).map(([u, v, s]) => Math.hypot(x - u, y - v) - r - s),
      );
      expect(gaps.filter((gap) => Math.abs(gap) < 1e-6).length).toBeGreaterThanOrEqual(touching);
    }
  });

  test("random circles: how many, how many hidden, the same again by their seed", async () => {
    const make = async (n, hidden, seed) => {
      await page.click("#open-sets");
      await page.fill("#random [name=n]", String(n));
      await page.fill("#random [name=hidden]", String(hidden));
      await page.fill("#random [name=seed]", String(seed));
      await page.evaluate(() => Object.assign(window, { old: app.sites }));
      await page.click("#random [type=submit]");
      await page.waitForFunction(() => app.sites !== window.old);
      return numbers();
    };
    const first = await make(400, 20, 9);
    expect(await stateOf(page)).toMatchObject({ size: 400, hidden: 80 });
    expect(await make(400, 20, 10)).not.toEqual(first);
    expect(await make(400, 20, 9)).toEqual(first);
  });

  test("more than 100 000 are made in a worker, which can be stopped", async () => {
    const before = await circlesOf(page);
    await page.evaluate(() => {
      window.loading = app.navigation.load("random", { n: "1000000", hidden: "5" });
    });
    await page.waitForSelector("#progress:not([hidden])");
    expect(await page.textContent("#progress-text")).toMatch(/Making circles|Building/);
    await page.click("#progress-cancel");
    await page.evaluate(() => window.loading);
    expect(await page.isVisible("#progress")).toBe(false);
    expect(await page.isVisible("#notice")).toBe(false);
    expect(await circlesOf(page)).toEqual(before);

    await page.evaluate(() => app.navigation.load("random", { n: "120000", hidden: "5" }));
    expect(await page.evaluate(() => [app.diagram.size, app.diagram.hiddenSize])).toEqual([
      120_000, 6000,
    ]);
    await page.evaluate(() => app.painter.flush());
    await page.mouse.move(500, 400);
    const { id } = await page.evaluate(() => app.pointer.hover);
    expect(await page.evaluate((id) => app.diagram.isHidden(id), id)).toBe(false);
    await page.click("#tool-undo"); // it is exact, but checking it takes long
  });

  describe("text", () => {
    test.each([
      ["CSV with names", "x,y,r,name\n1,2,3,first\n10,20,4.5,\n-7,1000,0,third\n"],
      ["CSV in other order", "name;radius;cy;cx\nfirst;3;2;1\n;4.5;20;10\nthird;0;1000;-7"],
      ["TSV without names of columns", "1\t2\t3\tfirst\n10\t20\t4.5\n-7\t1e3\t0\n"],
      ["rows of numbers", "[[1, 2, 3], [10, 20, 4.5], [-7, 1e3]]"],
      ["flat numbers", "[1, 2, 3, 10, 20, 4.5, -7, 1000, 0]"],
      ["objects", '[{"x":1,"y":2,"r":3},{"cx":10,"cy":20,"radius":4.5},{"x":-7,"y":1e3}]'],
      [
        "GeoJSON",
        JSON.stringify({
          type: "FeatureCollection",
          features: kThree.map(([x, y, r]) => ({
            type: "Feature",
            geometry: { type: "Point", coordinates: [x, y] },
            properties: { r },
          })),
        }),
      ],
    ])("%s", async (_, text) => {
      await page.click("#open-sets");
      await page.fill("#paste", text);
      await page.click("#load-text");
      await page.waitForFunction(() => app.diagram.size === 3);
      expect(await numbers()).toEqual(kThree);
    });

    test.each([
      ["", /no text/],
      ["x,y\n1,two\n", /row 2, column y/],
      ["a,b\n1,2\n", /columns x and y/],
      ["[[1,2,3],[4]]", /row 2, column y/],
      ["[1, 2", /JSON|array/],
      ["[[1, 2, 1e300]]", /1e\+?300/],
    ])("nonsense is refused with its reason, and nothing changes: %j", async (text, reason) => {
      const before = await circlesOf(page);
      await page.click("#open-sets");
      await page.fill("#paste", text);
      await page.click("#load-text");
      await page.waitForSelector("#notice:not([hidden])");
      expect(await page.textContent("#notice")).toMatch(reason);
      expect(await circlesOf(page)).toEqual(before);
      expect(await page.evaluate(() => app.model.history.canUndo)).toBe(false);
    });

    test("names are shown", async () => {
      await page.evaluate(async () => {
        const { sitesFromText } = app.parts;
        app.navigation.show(await sitesFromText('x,y,r,name\n0,0,5,"Berlin, Mitte"\n20,0,3,Other'));
      });
      expect(await page.evaluate(() => app.sites.label(0).name)).toBe("Berlin, Mitte");
    });
  });

  describe("files", () => {
    /** Returns the file that is saved in this format. */
    const saved = async (format) => {
      await page.click("#open-share");
      const [download] = await Promise.all([
        page.waitForEvent("download"),
        page.click(`[data-format=${format}]`),
      ]);
      await page.keyboard.press("Escape");
      return readFileSync(await download.path());
    };

    test.each(["csv", "json"])("%s is read as it was written", async (format) => {
      await show(page, "nesting");
      await page.evaluate(() => app.model.remove([2]));
      const before = await numbers();
      const file = await saved(format);
      await show(page, "two");
      const buffer = Buffer.from(file);
      await page.setInputFiles("#file", { name: `a.${format}`, mimeType: "", buffer });
      await page.waitForFunction((size) => app.diagram.size === size, before.length);
      expect(await numbers()).toEqual(before);
    });

    test("SVG and GeoJSON have every cell; PNG is a picture of the window", async () => {
      const svg = (await saved("svg")).toString();
      const groups = svg.match(/^<g class="(circles|hidden)">.*$/gm).join("");
      expect(groups.match(/<circle /g)).toHaveLength(2 * 35); // a disc and a rim of each
      expect(svg).toMatch(/<g class="cells"><path d="M[^"]{500,}"/);
      const { features } = JSON.parse((await saved("geojson")).toString());
      expect(features.filter(({ geometry }) => geometry.type !== "Point")).toHaveLength(33);
      const png = await saved("png");
      expect([png.readUInt32BE(16), png.readUInt32BE(20)]).toEqual([1280, 800]);
    });
  });

  describe("the address", () => {
    /** The page that the address of this one opens. */
    const again = async () => {
      const hash = await page.evaluate(() => {
        app.navigation.write();
        return location.hash;
      });
      const other = await open({ path: hash });
      return [other, hash];
    };

    test("holds set, edits, view and layers", async () => {
      await show(page, "cities");
      await page.evaluate(() => {
        app.model.update([5], Float64Array.of(1, 2, 333.25));
        app.model.remove([7, 8]);
        app.edits.insertCircle({ x: 12.5, y: -1000, r: 100 });
        app.setLayer("dual", true);
        app.camera.zoom(3, 500, 300);
      });
      const [other, hash] = await again();
      expect(hash.length).toBeLessThan(200);
      const circles = (page) =>
        page.evaluate(() => [...app.sites.triples(app.sites.ids)].map(String).sort());
      expect(await circles(other)).toEqual(await circles(page));
      const look = (page) => page.evaluate(() => [app.view.scale, app.painter.layers.dual]);
      const [scale, dual] = await look(other);
      expect(dual).toBe(true);
      expect(scale / (await look(page))[0]).toBeCloseTo(1, 4);
      expect(other.errors).toEqual([]);
      await closePage(other);
    });

    test("holds circles of the visitor's own, with their names", async () => {
      await page.evaluate(async () => {
        const { sitesFromText } = app.parts;
        app.navigation.show(await sitesFromText("x,y,r,name\n0,0,5,a~b&c=d\n20,0,3,\n"));
      });
      const [other] = await again();
      expect((await circlesOf(other)).map((row) => row.slice(1))).toEqual(await numbers());
      expect(await other.evaluate(() => app.sites.label(0).name)).toBe("a~b&c=d");
      await closePage(other);
    });

    test("Back and Forward go from set to set, edits included", async () => {
      await showCircles(page, kThree.flat());
      await page.evaluate(() => app.model.remove([1]));
      const edited = await numbers();
      await show(page, "gasket");
      const gasket = await numbers();
      await page.goBack();
      await page.waitForFunction(() => app.diagram.size === 2);
      expect(await numbers()).toEqual(edited);
      await page.goForward();
      await page.waitForFunction((size) => app.diagram.size === size, gasket.length);
      await page.goBack();
      await page.waitForFunction(() => app.diagram.size === 2);
    });

    test("an unknown part of it is passed over: links once had to=centres", async () => {
      const other = await open({ path: "#set=two&edits=1:260,40,50&to=centres&show=dual" });
      expect(await circlesOf(other)).toEqual([
        [0, 0, 0, 90],
        [1, 260, 40, 50],
      ]);
      const hash = await other.evaluate(() => app.navigation.write().hash);
      expect(hash).toMatch(/^#set=two&edits=1:260,40,50&view=[^&]+&show=dual$/);
      expect(other.errors).toEqual([]);
      await closePage(other);
    });

    test("a circle that the page has moved is where it was left", async () => {
      const moving = await open({ reducedMotion: "no-preference" });
      const where = (page) => page.evaluate(() => app.sites.triples([3]).join());
      const home = await where(page);
      await moving.waitForFunction((home) => app.sites.triples([3]).join() !== home, home);
      await moving.click("#open-share");
      const left = await where(moving);
      expect(left).not.toBe(home);
      const hash = await moving.evaluate(() => location.hash);
      await closePage(moving);
      const other = await open({ path: hash });
      expect(await where(other)).toBe(left);
      await closePage(other);
    });

    test("many edits are packed; too many are said to be, and give no link", async () => {
      const moveAll = async (n) => {
        await show(page, "random", { n: String(n), hidden: "0" });
        await page.evaluate(() => {
          const { ids } = app.sites;
          app.model.update(
            ids,
            app.sites.triples(ids).map((v, k) => (k % 3 === 0 ? v + Math.PI : v)),
          );
        });
        await page.click("#open-share");
        return [await page.textContent("#link-note"), await page.isEnabled("#copy-link")];
      };
      expect(await moveAll(100)).toEqual([
        "The link holds the set, your changes and the view.",
        true,
      ]);
      const [other, hash] = await again();
      expect(hash).toContain("&packed=");
      expect(hash.length).toBeLessThan(8000);
      expect((await circlesOf(other)).map((row) => row.slice(1))).toEqual(await numbers());
      await closePage(other);
      await page.keyboard.press("Escape");
      const [note, isEnabled] = await moveAll(500);
      expect(note).toMatch(/^Too many changes for a link, which would have \d\d\s\d{3} characters/);
      expect(isEnabled).toBe(false);
    });

    test("a link that is damaged is refused with its reason", async () => {
      const other = await open({ path: "#set=opening&packed=AAAA" });
      expect(await other.textContent("#notice")).toMatch(/could not be shown/);
      expect((await stateOf(other)).size).toBe(35);
      await closePage(other);
    });

    test("after Back, Undo leads to no other set", async () => {
      await page.evaluate(() => app.model.remove([1]));
      await show(page, "gasket");
      await page.evaluate(() => app.model.remove([1]));
      await page.goBack();
      await page.waitForFunction(() => app.diagram.size === 34);
      expect(await page.isDisabled("#tool-undo")).toBe(true);
      await page.keyboard.press("Control+z");
      expect(await page.evaluate(() => [app.sites.info.key, app.diagram.size])).toEqual([
        "opening",
        34,
      ]);
      await page.evaluate(() => app.model.remove([2]));
      await page.keyboard.press("Control+z");
      expect((await stateOf(page)).size).toBe(34);
    });

    test("the title says which set it is", async () => {
      expect(await page.title()).toBe("Large and small · Apollonius diagram");
      await show(page, "gasket");
      expect(await page.title()).toBe("Apollonian gasket · Apollonius diagram");
      await page.goBack();
      await page.waitForFunction(() => app.sites.info.key === "opening");
      expect(await page.title()).toBe("Large and small · Apollonius diagram");
    });

    test.each(["", "why/"])("a link to %j has a picture", async (path) => {
      const other = path === "" ? page : await open({ path, ready: null });
      const size = await other.evaluate(async () => {
        const { content } = document.querySelector("meta[property='og:image']");
        const response = await fetch(new URL(content, location.href));
        const { width, height } = await createImageBitmap(await response.blob());
        return [response.headers.get("content-type"), width, height];
      });
      expect(size).toEqual(["image/png", 1200, 630]);
      if (other !== page) await closePage(other);
    });

    test("a reload keeps more edits than an address can hold", async () => {
      await show(page, "random", { n: "700", hidden: "0" });
      await page.evaluate(() => {
        const { ids } = app.sites;
        app.model.update(
          ids,
          app.sites.triples(ids).map((v, k) => (k % 3 === 0 ? v + 1 : v)),
        );
        app.navigation.write();
      });
      const edited = await numbers();
      await page.reload();
      await page.waitForFunction(() => window.app);
      expect(await numbers()).toEqual(edited);
    });
  });

  test("the code for this diagram runs and says what the page says", async () => {
    await page.click("#open-code");
    const code = await page.textContent("#code-text");
    const body = code
      .replace(/^import .*$/m, "")
      .replace(/^(diagram\.find.*);/m, "const found = $1;")
      .replace("const path =", "return [found, diagram.size, cells.render().length]; const path =");
    const { Diagram } = await import("../../dist/esm/index.js");
    const [found, size, length] = new Function("Diagram", body)(Diagram);
    expect(size).toBe(35);
    expect(length).toBeGreaterThan(1000);
    expect(String(found)).toBe(code.match(/\/\/ (\d+): the nearest/)[1]);
  });
});
