// Circles in files: the forms of tables, the messages about them, and that an exported file has all
// that the page shows and can be opened again.
import { readFileSync } from "node:fs";
import { describe, expect, test } from "@jest/globals";
import {
  circlesOf,
  describeInBrowser,
  forEachPage,
  settled,
  show,
  stateOf,
} from "./support/browser.mjs";

describeInBrowser("files", (open) => {
  let page;
  forEachPage(open, (opened) => {
    page = opened;
  });

  const numbers = async () => (await circlesOf(page)).map(([, x, y, r]) => [x, y, r]);
  const labels = () => page.evaluate(() => [...app.sites.labels]);
  const loadText = async (text) => {
    if (!(await page.isVisible("#sets"))) await page.click("#open-sets");
    await page.fill("#paste", text);
    await page.click("#load-text");
  };
  const notice = async () => {
    await page.waitForSelector("#notice:not([hidden])");
    return page.textContent("#notice");
  };

  describe("tables", () => {
    test.each([
      ["decimal commas", "1,5;2,5\n-3,25;,5;1,5e1", [1.5, 2.5, 0, -3.25, 0.5, 15]],
      ["decimal commas, with a head", "x;y;radius\n1,5;2;0,5\n", [1.5, 2, 0.5]],
      [
        "comments and blank rows",
        "\n# a, b\n\nx,y,r\n # 7,8,9\n1,2,3\n\n , \n4,5,6",
        [1, 2, 3, 4, 5, 6],
      ],
      ["names that begin with #", "name,x,y,r\n#1,1,2,3\n# nothing\n", [1, 2, 3]],
      ["spaces, some of them several", "x y r\n 1 2   3 \n4  5 6", [1, 2, 3, 4, 5, 6]],
      ["thousands with commas", 'x,y,r\n"1,234","-1,234,567.5",10', [1234, -1234567.5, 10]],
      ["thousands beside semicolons", "x;y;r\n1,234,567;2;3", [1234567, 2, 3]],
      ["names in German", "Länge;Breite;reach\n7,5;51;2", [7.5, 51, 2]],
      ["units after names", "X (km)\tY (km)\tRadius [km]\n1\t2\t3", [1, 2, 3]],
      ["a radius that is called weight", "weight,y,x\n3,2,1", [1, 2, 3]],
      ["a separator within quotes", 'name,x,y,r\n"a; b",1,2,3', [1, 2, 3]],
    ])("%s", async (_, text, expected) => {
      await loadText(text);
      await page.waitForFunction((size) => app.diagram.size === size, expected.length / 3);
      expect((await numbers()).flat()).toEqual(expected);
    });

    test.each([
      ["utf8", false],
      ["latin1", true],
      ["utf16le", false],
    ])("a file in %s", async (encoding, isSaid) => {
      const text = `${encoding === "utf16le" ? "\uFEFF" : ""}x,y,r,name\n1,2,3,Köln\n`;
      const buffer = Buffer.from(text, encoding);
      await page.setInputFiles("#file", { name: "a.csv", mimeType: "text/csv", buffer });
      await page.waitForFunction(() => app.diagram.size === 1);
      expect(await labels()).toEqual([[0, { name: "Köln" }]]);
      if (isSaid) expect(await notice()).toMatch(/not UTF-8.*Windows-1252/);
    });

    test.each(["value", "size", "population", "area"])("%s is an area", async (column) => {
      await loadText(`x,y,${column},name\n0,0,100,a\n1000,0,400,b\n500,800,0,c\n`);
      await page.waitForFunction(() => app.diagram.size === 3);
      const [[, , small], [, , large], [, , none]] = await numbers();
      expect(large / small).toBeCloseTo(2, 9);
      expect(none).toBe(0);
      expect(large).toBeGreaterThan(10); // it can be seen,
      expect(large).toBeLessThan(500); // and leaves room
      expect(await notice()).toContain(`“${column}”`);
      expect((await labels())[1]).toEqual([1, { name: "b", detail: `${column}: 400` }]);
    });

    test("without radii the page says that there are none, and the view has a size", async () => {
      await loadText("x,y\n10,20\n");
      await page.waitForFunction(() => app.diagram.size === 1);
      expect(await notice()).toContain("points");
      expect(await page.evaluate(() => app.view.width / app.view.scale)).toBeGreaterThan(1);
    });

    test.each([
      ["x,y\n1,2\n\n# not this\n3,two\n", "row 5, column y: “two” is no number"],
      ["lat;lon;radius\n1;2;\n1,5;2;wide\n", "row 3, column radius: “wide” is no number"],
      ["x,y,r\n1,,3\n", "row 2, column y: there is no value"],
      ["x,y,value\n1,2,-3", "row 2, column value: an area is not negative"],
      ["town,size\nA,2\n", "row 1 has no columns x and y, but “town”, “size”"],
      ["x,y,r\n1,2,1e300", "row 2, column r: 1e+300 is out of range"],
      ['[{"x": 1, "y": 2}, {"x": 3, "y": "?"}]', "row 2, column y: “?” is no number"],
      ["[1, 2, 3, 4]", "4 numbers are no circles"],
      ["# nothing\n", "only comments"],
    ])("what is wrong is said: %j", async (text, message) => {
      await loadText(text);
      expect(await notice()).toContain(message);
      expect((await stateOf(page)).size).toBe(35);
    });

    test("what failed is forgotten when it has been mended", async () => {
      await loadText("x,y,r\n1,two,3");
      await notice();
      await loadText("x,y,r\n1,2,3");
      await page.waitForFunction(() => app.diagram.size === 1);
      expect(await page.isVisible("#notice")).toBe(false);
    });
  });

  test("a dropped file is read, not opened in place of the page", async () => {
    await page.evaluate(() => {
      const data = new DataTransfer();
      data.items.add(new File(["x,y,r\n1,2,3\n10,20,4\n"], "two.csv"));
      const event = (type) =>
        new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true });
      const results = ["dragover", "drop"].map((type) => document.body.dispatchEvent(event(type)));
      if (results.some(Boolean)) throw new Error("the browser would open the file");
    });
    await page.waitForFunction(() => app.diagram.size === 2);
    expect((await circlesOf(page)).map((row) => row.slice(1))).toEqual([
      [1, 2, 3],
      [10, 20, 4],
    ]);
  });

  describe("exports", () => {
    /** Returns the file that is saved in this format, and its name. */
    const saved = async (format) => {
      await page.click("#open-share");
      const [download] = await Promise.all([
        page.waitForEvent("download"),
        page.click(`[data-format=${format}]`),
      ]);
      await page.keyboard.press("Escape");
      const buffer = readFileSync(await download.path());
      return { name: download.suggestedFilename(), mimeType: "", buffer };
    };
    const reopened = async (file, size) => {
      await show(page, "two");
      await page.setInputFiles("#file", file);
      await page.waitForFunction((size) => app.diagram.size === size, size);
    };

    /** Returns what is on the page of a map of the Earth, and what the tag says of distances. */
    const earth = () =>
      page.evaluate(async () => {
        const id = app.sites.ids.find((id) => app.sites.label(id).name === "Istanbul");
        const { x, y } = app.sites.site(id);
        app.pointer.moveTo({ x: app.view.toScreenX(x), y: app.view.toScreenY(y) });
        await app.whenShown();
        const canvas = app.painter.canvas("map");
        const { data } = canvas
          .getContext("2d")
          .getImageData(canvas.width / 2, 0, 1, canvas.height);
        const box = document.getElementById("layer-map");
        return {
          said: tag.textContent,
          unit: app.sites.info.areaUnit,
          layer: !box.hidden,
          credit: !document.getElementById("credit").hidden,
          colours: new Set(new Uint32Array(data.buffer)).size > 3, // land, sea and coast
        };
      });
    const kOnEarth = {
      said: expect.stringMatching(/^Istanbul 2\d\d km inside/),
      unit: "km²",
      layer: true,
      credit: true,
      colours: true,
    };

    test("SVG has every layer that is shown, and no other", async () => {
      const layersOf = () =>
        page.evaluate(() => {
          const svg = new DOMParser().parseFromString(app.parts.toSvg(app), "image/svg+xml");
          const groups = [...svg.querySelectorAll("svg > g")];
          return groups.map((group) => [group.getAttribute("class"), group.childElementCount > 0]);
        });
      const names = ["distances", "cells", "circles", "hidden", "names"];
      expect((await layersOf()).map(([name]) => name)).toEqual(names);
      await page.evaluate(() => {
        for (const name of Object.keys(app.painter.layers)) app.setLayer(name, true);
      });
      const all = ["distances", "centres", "dual", "cells", "vertices", "levels", "hull"];
      expect(await layersOf()).toEqual([
        ...all.map((name) => [name, true]),
        ["circles", true],
        ["hidden", true],
        ["names", false], // they have none
      ]);
      await show(page, "cities");
      await page.evaluate(() => app.camera.zoom(8, 640, 200));
      await settled(page);
      const ofCities = new Map(await layersOf());
      expect([ofCities.get("map"), ofCities.get("names")]).toEqual([true, true]);
    });

    test("SVG looks as the page does", async () => {
      await page.evaluate(() => {
        for (const name of ["hull", "vertices", "centres"]) app.setLayer(name, true);
        app.model.insert(Float64Array.of(20, 20, -5)); // a cross
      });
      const differing = await page.evaluate(async () => {
        const shown = app.painter.toCanvas();
        const { width, height } = shown;
        const picture = new Image();
        picture.src = `data:image/svg+xml,${encodeURIComponent(app.parts.toSvg(app))}`;
        await picture.decode();
        const drawn = new OffscreenCanvas(width, height).getContext("2d");
        drawn.drawImage(picture, 0, 0);
        const [a, b] = [shown.getContext("2d"), drawn].map(
          (context) => context.getImageData(0, 0, width, height).data,
        );
        let count = 0;
        for (let k = 0; k < a.length; k += 4)
          if (Math.abs(a[k] - b[k]) + Math.abs(a[k + 1] - b[k + 1]) > 12) count++;
        return count / (width * height);
      });
      expect(differing).toBeLessThan(0.01);
      const circles = await page.evaluate(() =>
        app.parts
          .toSvg(app)
          .match(/<circle [^>]*r="[\d.]+"/g)
          .map((tag) => tag.split('"')[5]),
      );
      const radii = await page.evaluate(() =>
        [0, 1, 2].map((id) => (app.sites.site(id).r * app.view.scale).toFixed(2)),
      );
      expect(circles).toEqual(expect.arrayContaining(radii.map((r) => String(Number(r)))));
    });

    test("GeoJSON holds circles, names and areas, and is opened again", async () => {
      await loadText('x,y,r,name,detail\n0,0,9,"A, a",first\n1,1,2,inside,\n40,0,3,C,third\n');
      await page.waitForFunction(() => app.diagram.size === 3);
      const before = [await numbers(), await labels()];
      const file = await saved("geojson");
      const { features } = JSON.parse(file.buffer);
      expect(features.map(({ geometry }) => geometry.type)).toEqual([
        "Polygon",
        "Polygon",
        "Point",
      ]);
      const [{ properties }] = features;
      expect(properties).toMatchObject({ name: "A, a", detail: "first", x: 0, y: 0, r: 9 });
      expect(properties.area).toBeGreaterThan(0);
      expect(features[2].properties).toMatchObject({ name: "inside", hidden: true, area: null });
      await reopened(file, 3);
      // Those without a cell come last.
      const order = (rows) => [rows[0], rows[2], rows[1]];
      expect(await numbers()).toEqual(order(before[0]));
      expect((await labels()).map(([, label]) => label.name)).toEqual(["A, a", "C", "inside"]);
    });

    test("GeoJSON of the cities is in longitude and latitude", async () => {
      await show(page, "cities");
      const { features } = JSON.parse((await saved("geojson")).buffer);
      expect(features).toHaveLength(1500);
      const flat = features
        .filter(({ geometry }) => geometry.type !== "Point")
        .flatMap(({ geometry }) => geometry.coordinates.flat(Infinity));
      const [lons, lats] = [0, 1].map((axis) => flat.filter((_, k) => k % 2 === axis));
      expect(Math.max(...lons.map(Math.abs))).toBe(180);
      expect(Math.max(...lats.map(Math.abs))).toBeLessThanOrEqual(90);
      expect(Math.max(...lats)).toBeGreaterThan(89.9); // cells are whole
      const istanbul = features.find(({ properties }) => properties.name === "Istanbul");
      const ring = istanbul.geometry.coordinates[0];
      const [west, east] = [Math.min, Math.max].map((of) => of(...ring.map(([lon]) => lon)));
      const [south, north] = [Math.min, Math.max].map((of) => of(...ring.map(([, lat]) => lat)));
      expect(west < 28.95 && 28.95 < east && south < 41.01 && 41.01 < north).toBe(true);
      const area = features.reduce((sum, { properties }) => sum + (properties.area ?? 0), 0);
      expect(area / (4 * Math.PI * 6371 ** 2)).toBeCloseTo(1, 3); // the whole Earth
    });

    test("cities in GeoJSON and in an address are on the map again", async () => {
      await show(page, "cities");
      await page.evaluate(() => app.model.remove(app.sites.ids.slice(20)));
      const file = await saved("geojson");
      await reopened(file, 20);
      expect(await earth()).toEqual(kOnEarth);
      await page.evaluate(() => app.navigation.write());
      await page.reload();
      await page.waitForFunction(() => window.app);
      expect(await earth()).toEqual(kOnEarth);
      const ofOthers = { ...JSON.parse(file.buffer), "apollonius-diagram": undefined };
      await reopened({ ...file, buffer: Buffer.from(JSON.stringify(ofOthers)) }, 20);
      expect((await earth()).said).not.toContain("km");
    });

    test("cities that are too many changes for a link are on the map again", async () => {
      await show(page, "cities");
      await page.evaluate(() => {
        app.model.update(
          app.sites.ids,
          app.sites.triples(app.sites.ids).map((v) => v + 0.1),
        );
        app.navigation.write();
      });
      await page.reload();
      await page.waitForFunction(() => window.app?.sites.site(0).r % 1 > 0);
      expect(await earth()).toEqual(kOnEarth);
    });
  });

  describe("kilometres", () => {
    const radians = (degrees) => (degrees * Math.PI) / 180;
    /** Great-circle distance by the haversine formula. */
    const kilometres = ([lon, lat], [lon_, lat_]) => {
      const h =
        Math.sin(radians(lat_ - lat) / 2) ** 2 +
        Math.cos(radians(lat)) * Math.cos(radians(lat_)) * Math.sin(radians(lon_ - lon) / 2) ** 2;
      return 2 * 6371 * Math.asin(Math.sqrt(h));
    };

    test("the card says the place, and how far the nearest centre is on the globe", async () => {
      await show(page, "cities");
      const city = await page.evaluate(() => {
        const [id] = [...app.sites.labels].find(([, { name }]) => name === "Honolulu");
        app.selection.set([id]);
        return id;
      });
      await settled(page);
      const facts = await page.textContent("#card-facts");
      expect(facts).toContain("21.3° N, 157.9° W");
      const [, name, distance] = facts.match(/nearest centre(\D+), ([\d\s]+) km/);
      const other = await page.evaluate((name) => {
        const id = app.sites.ids.find((id) => app.sites.label(id).name === name);
        return app.sites.info.globe.placeOf(app.sites, id);
      }, name);
      expect(await page.evaluate(() => app.selection.ids)).toEqual([city]);
      const expected = kilometres([-157.86, 21.31], other);
      expect(Math.abs(Number(distance.replace(/\D/g, "")) - expected)).toBeLessThan(10);
    });

    test("the tag says true distances, and who is nearest on the globe", async () => {
      await show(page, "cities");
      const found = await page.evaluate(async () => {
        const { globe } = app.sites.info;
        for (let lon = -175; lon < 180; lon += 5)
          for (let lat = 60; lat > -60; lat -= 5) {
            const [x, y] = app.parts.equalEarth([lon, lat]);
            const onMap = app.diagram.find(x, y);
            const { id, distance } = globe.nearest(app.sites, [lon, lat]);
            if (id === onMap) continue;
            app.pointer.moveTo({ x: app.view.toScreenX(x), y: app.view.toScreenY(y) });
            await app.whenShown();
            const cities = [onMap, id].map((id) => ({
              place: globe.placeOf(app.sites, id),
              r: app.sites.site(id).r,
            }));
            const { name } = app.sites.label(id);
            return { at: [lon, lat], cities, name, distance, said: tag.textContent };
          }
      });
      const [onMap, onGlobe] = found.cities.map(({ place, r }) => kilometres(found.at, place) - r);
      expect(onGlobe).toBeCloseTo(found.distance, 6);
      expect(onGlobe).toBeLessThan(onMap);
      const text = (km) => Math.round(km).toLocaleString("en").replace(",", "\u202f");
      expect(found.said).toContain(
        ` ${text(onMap)} km; nearer on Earth: ${found.name} ${text(onGlobe)} km`,
      );
      const nearby = await page.evaluate(() => {
        const { x, y } = app.sites.site(1);
        app.pointer.moveTo({ x: app.view.toScreenX(x), y: app.view.toScreenY(y) });
        return app.whenShown().then(() => document.getElementById("tag").textContent);
      });
      expect(nearby).toMatch(/^Istanbul 2\d\d km inside/);
    });
  });
});
