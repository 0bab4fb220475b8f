// The examples of web/examples keep their promises, in the browser.
import { mkdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { fileURLToPath } from "node:url";
import { expect, test } from "@jest/globals";
import { closePage, describeInBrowser } from "./support/browser.mjs";
import { isThorough } from "../support/effort.mjs";

const pictures = fileURLToPath(new URL("../../build/pictures/", import.meta.url));
const index = readFileSync(new URL("../../web/examples/gallery.js", import.meta.url), "utf8");
const names = [...index.matchAll(/^ {2}(\w+): \[/gm)].map((match) => match[1]);

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

describeInBrowser("examples", (open) => {
  /**
   * Runs `check` in the page of an example, with what the example returned, and gives it the
   * address of the package's diagnostics; keeps a picture for people to look at.
   */
  async function inExample(name, check, act = async () => {}) {
    const page = await open({
      path: `examples/#${name}`,
      ready: "example",
      viewport: { width: 1000, height: 660 },
    });
    await act(page);
    const diagnostics = new URL("../lib/apollonius-diagram/diagnostics.js", page.url()).href;
    const found = await page.evaluate(check, diagnostics);
    mkdirSync(pictures, { recursive: true });
    await page.screenshot({ path: `${pictures}example_${name}.png` });
    expect(page.errors).toEqual([]);
    await closePage(page);
    return found;
  }

  test("comparison: the plain diagram picks a bubble that the pointer is not in", async () => {
    const found = await inExample("comparison", () => {
      const {
        bubbles,
        plain,
        weighted,
        worst: [x, y],
      } = window.example;
      const isIn = (id) => Math.hypot(bubbles[id].x - x, bubbles[id].y - y) < bubbles[id].r;
      return [isIn(plain), isIn(weighted)];
    });
    expect(found).toEqual([false, true]);
  });

  test("bubble_chart: what is pointed at is picked, hidden bubbles too", async () => {
    const found = await inExample(
      "bubble_chart",
      () => {
        const { bubbles, diagram, pick } = window.example;
        const distance = (b, x, y) => Math.hypot(b.x - x, b.y - y) - b.r;
        let wrong = 0,
          hidden = 0;
        for (let x = 2; x < 920; x += 13) {
          for (let y = 2; y < 480; y += 13) {
            const under = bubbles.filter((b) => distance(b, x, y) <= 0);
            const best =
              under.length > 0
                ? under.reduce((a, b) => (b.r < a.r ? b : a))
                : bubbles.reduce((a, b) => (distance(b, x, y) < distance(a, x, y) ? b : a));
            wrong += bubbles[pick(x, y)] !== best;
            hidden += diagram.isHidden(pick(x, y));
          }
        }
        return {
          wrong,
          hidesSome: hidden > 0,
          marked: document.querySelectorAll('circle[fill="#e15759"]').length,
        };
      },
      (page) => page.mouse.move(500, 300),
    );
    expect(found).toEqual({ wrong: 0, hidesSome: true, marked: 1 });
  });

  test("force: the diagram follows the circles", async () => {
    const found = await inExample(
      "force",
      async (diagnostics) => {
        const { validate } = await import(diagnostics);
        const { diagram, nodes, simulation } = window.example;
        simulation.stop();
        const apart = nodes.filter(({ x, y, r }, id) => {
          const site = diagram.site(id);
          return site.x !== x || site.y !== y || site.r !== r;
        });
        return {
          size: diagram.size,
          apart: apart.length,
          broken: validate(diagram),
          alpha: simulation.alpha(),
        };
      },
      async (page) => {
        await page.mouse.move(480, 300);
        await page.waitForFunction(() => window.example.simulation.alpha() < 0.8);
      },
    );
    expect(found).toMatchObject({ size: 400, apart: 0, broken: null });
  });

  /**
   * Stops the simulation, whenever that is; returns some circles whose centres are in no other one,
   * so that they are nearest to their centres and drawn there.
   */
  const stopForce = (page, count) =>
    page.evaluate((count) => {
      const { nodes, simulation } = window.example;
      simulation.stop();
      const isApart = (a) =>
        nodes.every((b) => a === b || Math.hypot(a.x - b.x, a.y - b.y) > b.r + 2);
      const inside = ({ x, y }) => x > 10 && x < 910 && y > 10 && y < 470;
      return nodes
        .map(({ x, y, r }, id) => ({ id, x, y, r }))
        .filter((node) => inside(node) && isApart(nodes[node.id]))
        .slice(0, count);
    }, count);

  test("force: once it rests, the pointer is still answered", async () => {
    const page = await open({ path: "examples/#force", ready: "example" });
    const [{ id, x, y }] = await stopForce(page, 1);
    const box = await (await page.$("figure canvas")).boundingBox();
    /** The colour in the middle of the circle. */
    const colour = () =>
      page.evaluate(
        ([x, y]) => {
          const context = document.querySelector("figure canvas").getContext("2d");
          return [...context.getImageData(x, y, 1, 1).data.slice(0, 3)];
        },
        [x, y],
      );
    expect(await colour()).toEqual([0x4e, 0x79, 0xa7]);
    await page.mouse.move(box.x + (x * box.width) / 920, box.y + (y * box.height) / 480);
    await page.waitForFunction((id) => window.example.lit() === id, id);
    expect(await colour()).toEqual([0xe1, 0x57, 0x59]);
    await closePage(page);
  });

  test("on a phone, where canvases are shown smaller, the pointer means the same", async () => {
    const phone = { viewport: { width: 390, height: 700 } };
    const page = await open({ path: "examples/#force", ready: "example", ...phone });
    const nodes = await stopForce(page, 3);
    expect(nodes.length).toBe(3);
    const box = await (await page.$("figure canvas")).boundingBox();
    expect(box.width).toBeLessThan(380);
    for (const { id, x, y } of nodes) {
      await page.mouse.move(box.x + (x * box.width) / 920, box.y + (y * box.height) / 480);
      await page.waitForFunction((id) => window.example.lit() === id, id);
    }
    await closePage(page);
  });

  const themes = isThorough ? ["light", "dark"] : ["dark"];
  test.each(themes)("cards: all of them, drawn, and clean by axe; %s", async (theme) => {
    for (const width of isThorough ? [390, 1100] : [theme === "light" ? 390 : 1100]) {
      const page = await open({
        path: "examples/",
        ready: () =>
          document.querySelector(".card") && !document.querySelector(".card:not([data-shown])"),
        colorScheme: theme,
        viewport: { width, height: width < 500 ? 4800 : 2600 },
      });
      const cards = await page.evaluate(() => document.querySelectorAll(".card").length);
      expect(cards).toBe(names.length);
      mkdirSync(pictures, { recursive: true });
      await page.screenshot({ path: `${pictures}examples_${theme}_${width}.png` });
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(
        width,
      );
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => window.axe.run());
      expect(violations.map(({ id }) => id)).toEqual([]);
      await page.click(`a[href="#${names[0]}"]`);
      await page.waitForFunction(() => window.example);
      expect(await page.textContent("pre code")).toContain("export default function");
      await page.evaluate(axe);
      const again = await page.evaluate(() => window.axe.run());
      expect(again.violations.map(({ id }) => id)).toEqual([]);
      await page.click("#back");
      await page.waitForSelector(".cards");
      expect(page.errors).toEqual([]);
      await closePage(page);
    }
  });

  test("worker: every pixel has its circle", async () => {
    const found = await inExample("worker", () => {
      const { ids, distances, width, height } = window.example;
      return {
        all: ids.length === width * height,
        known: ids.every((id) => id >= 0 && id < 60),
        some: new Set(ids).size > 20,
        finite: distances.every(Number.isFinite),
      };
    });
    expect(found).toEqual({ all: true, known: true, some: true, finite: true });
  });

  test("empty_circles: they overlap nothing, and nowhere in the window is more room", async () => {
    const found = await inExample("empty_circles", () => {
      const { circles, empty } = window.example;
      const gap = (a, b) => Math.hypot(a.x - b.x, a.y - b.y) - a.r - b.r;
      const overlaps = empty
        .flatMap((a, k) => [...circles, ...empty.slice(0, k)].map((b) => gap(a, b)))
        .filter((g) => g < -1e-9);
      const places = Array.from({ length: 93 * 49 }, (_, k) => ({
        x: 10 * (k % 93),
        y: 10 * Math.floor(k / 93),
        r: 0,
      }));
      const roomier = empty.filter((a, k) => {
        const others = [...circles, ...empty.slice(0, k)];
        const isRoomier = (place) =>
          Math.min(place.x, 920 - place.x, place.y, 480 - place.y) * 0.999 > a.r &&
          others.every((b) => gap(place, b) * 0.999 > a.r);
        return places.some(isRoomier);
      });
      const descending = empty.every((a, k) => k === 0 || a.r * 0.999 <= empty[k - 1].r);
      const beyond = empty.filter(
        ({ x, y, r }) => Math.min(x, 920 - x, y, 480 - y) < r * (1 - 1e-9),
      );
      return {
        beyond: beyond.length,
        count: empty.length,
        overlaps: overlaps.length,
        roomier: roomier.length,
        descending,
      };
    });
    expect(found).toEqual({
      beyond: 0,
      count: 12,
      overlaps: 0,
      roomier: 0,
      descending: true,
    });
  });

  test("grow: more is covered the farther cells reach, and at last all of it", async () => {
    const found = await inExample("grow", () => {
      const { slider, covered, circles } = window.example;
      const at = (value) => {
        slider.value = value;
        slider.dispatchEvent(new Event("input"));
        return covered();
      };
      let inside = 0;
      for (let x = 5; x < 920; x += 10)
        for (let y = 5; y < 480; y += 10)
          inside += circles.some((c) => Math.hypot(x - c.x, y - c.y) - c.r <= 26);
      return { shares: [0, 26, 60].map(at), sampled: inside / (92 * 48) };
    });
    expect(found.shares[1]).toBeCloseTo(found.sampled, 1);
    expect(found.shares[0]).toBeLessThan(found.shares[1]);
    expect(found.shares[1]).toBeLessThan(found.shares[2]);
    expect(found.shares[2]).toBeLessThanOrEqual(1 + 1e-9);
  });

  test("clearance_path: a disc of that radius passes along it, from side to side", async () => {
    const found = await inExample("clearance_path", () => {
      const { circles, path, clearance } = window.example;
      const inside = path.every(
        ([x, y]) => x >= -1e-9 && y >= -1e-9 && x <= 920 + 1e-9 && y <= 480 + 1e-9,
      );
      const between = path
        .slice(1)
        .flatMap(([x, y], k) =>
          [0, 0.25, 0.5, 0.75].map((t) => [x + (path[k][0] - x) * t, y + (path[k][1] - y) * t]),
        );
      const room = between.map(([x, y]) =>
        Math.min(...circles.map((c) => Math.hypot(c.x - x, c.y - y) - c.r)),
      );
      return {
        inside,
        narrowest: Math.min(...room) - clearance,
        positive: clearance > 0,
        from: path[0][0],
        to: path.at(-1)[0],
        length: path.length,
      };
    });
    // nowhere closer to a disc than it says, except by the chords,
    expect(found.narrowest).toBeGreaterThan(-0.01);
    // and as close as that somewhere (between the points that were looked at)
    expect(found.narrowest).toBeLessThan(0.5);
    expect(found.inside).toBe(true);
    expect(found.positive).toBe(true);
    expect(found.from).toBeLessThan(150);
    expect(found.to).toBeGreaterThan(770);
  });

  test("capacities: each city has as much of the country as it has of the beds", async () => {
    const found = await inExample("capacities", () => {
      const { cities, areas, error } = window.example;
      const all = areas.cellAreas();
      const [land, beds] = [
        all.reduce((sum, area) => sum + area, 0),
        cities.reduce((sum, city) => sum + city.beds, 0),
      ];
      const shares = cities.map((city, id) => all[id] / land / (city.beds / beds));
      return {
        error,
        land,
        count: cities.length,
        off: Math.max(...shares.map((share) => Math.abs(share - 1))),
      };
    });
    expect(found.count).toBeGreaterThan(20);
    expect(found.error).toBeLessThan(1e-6);
    expect(found.off).toBeLessThan(2e-6);
    expect(Math.abs(found.land / 783_562 - 1)).toBeLessThan(0.01); // km², as the state says
  });

  test("treemap: areas are shares of the whole, cells are inside their region's", async () => {
    const found = await inExample("treemap", () => {
      const { root } = window.example;
      const whole = root.children.reduce((sum, { area }) => sum + area, 0);
      const shares = root
        .descendants()
        .slice(1)
        .map(({ area, value }) => area / whole / (value / root.value));
      const shape = document.createElementNS("http://www.w3.org/2000/svg", "path");
      document.querySelector("svg").append(shape);
      const outside = root.leaves().filter(({ parent, centroid: [x, y] }) => {
        shape.setAttribute("d", parent.render());
        return !shape.isPointInFill(new DOMPoint(x, y));
      });
      // Names are in their cells: the corners of their boxes are.
      const cut = [...document.querySelectorAll("svg text")].filter((text) => {
        const { x, y, width, height } = text.getBBox();
        const { leaf, ...name } = text.__data__;
        shape.setAttribute("d", leaf.render());
        return [0, 1, 2, 3].some((corner) => {
          const px = name.x + x + (corner & 1 ? width : 0);
          const py = name.y + y + (corner & 2 ? height : 0);
          return !shape.isPointInFill(new DOMPoint(px, py));
        });
      });
      shape.remove();
      return {
        cut: cut.map((text) => text.textContent),
        count: shares.length,
        off: Math.max(...shares.map((share) => Math.abs(share - 1))),
        outside: outside.length,
        said: document.querySelector("svg title").textContent,
      };
    });
    expect(found.count).toBe(156);
    expect(found.off).toBeLessThan(1e-6);
    expect(found.outside).toBe(0);
    expect(found.cut).toEqual([]);
    expect(found.said).toMatch(/^China: 17 %\nEast Asia and Pacific: 31 %$/);
  });

  test("nested: what is pointed at grows, and each area stays its share", async () => {
    const found = await inExample(
      "nested",
      () => {
        const { root, sizes } = window.example;
        const leaf = root.leaves().reduce((a, b) => (b.value / b.data.size > 7 ? b : a), null);
        const shares = root
          .descendants()
          .map(({ area, value }) => area / root.area / (value / root.value));
        return {
          said: document.querySelector("output").textContent,
          grown: leaf?.data.name,
          others: [...sizes].filter(([data, size]) => size > 1.1 * data.size).length,
          off: Math.max(...shares.map((share) => Math.abs(share - 1))),
        };
      },
      async (page) => {
        await page.mouse.move(520, 330);
        await page.waitForFunction(() =>
          window.example.root.leaves().some(({ value, data }) => value > 7.8 * data.size),
        );
      },
    );
    expect(found.said).toMatch(/^flare › \w+ › /);
    expect(found.said.split(" › ").at(-1)).toBe(found.grown);
    expect(found.others).toBe(1);
    expect(found.off).toBeLessThan(1e-6);
  });

  test("cities: cells end at the coast, and add up to the land", async () => {
    const found = await inExample("cities", async () => {
      const { cells, areas } = window.example;
      const { land } = await (await fetch("/web/data/land.json")).json();
      const areaOf = (steps) => {
        let [x, y, sum] = [steps[0], steps[1], 0];
        for (let k = 2; k < steps.length; k += 2) {
          sum += (x * steps[k + 1] - y * steps[k]) / 2;
          x += steps[k];
          y += steps[k + 1];
        }
        return sum + (x * steps[1] - y * steps[0]) / 2;
      };
      return {
        share: areas.reduce((a, b) => a + b) / Math.abs(land.map(areaOf).reduce((a, b) => a + b)),
        parts: cells.cellParts(1).length,
        paths: document.querySelectorAll("path.city").length,
      };
    });
    expect(found.share).toBeCloseTo(1, 7); // rings of the simplified outline cross here and there
    expect(found.parts).toBeGreaterThan(1); // Istanbul, on both sides of the Bosporus
    expect(found.paths).toBe(1500);
  });

  test("globe: all cities are in the diagram, most of them drawn in colour", async () => {
    const found = await inExample("globe", async (diagnostics) => {
      const { validate } = await import(diagnostics);
      const { diagram, canvas } = window.example;
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      const pixels = new Uint32Array(data.buffer);
      return {
        size: diagram.size,
        broken: validate(diagram),
        isColoured: new Set(pixels).size > 50,
        said: document.querySelector("output").textContent,
      };
    });
    expect(found).toMatchObject({ size: 1500, broken: null, isColoured: true });
    expect(found.said).toMatch(/^\p{L}.*: [\d,]+ km (away|inside its circle)$/u);
  });

  test("relax: areas stay, cells become rounder, and it stops if told to", async () => {
    const page = await open({ path: "examples/#relax", ready: "example" });
    const look = () =>
      page.evaluate(() => {
        const { cells, targets } = window.example;
        const areas = [...cells.cellAreas()];
        const perTarget =
          areas.reduce((sum, area) => sum + area) / targets.reduce((sum, one) => sum + one);
        const lengths = cells.cellPerimeters();
        return {
          off: Math.max(...areas.map((area, id) => Math.abs(area / perTarget / targets[id] - 1))),
          // of circles: 1
          round:
            areas.reduce((sum, a, id) => sum + (4 * Math.PI * a) / lengths[id] ** 2, 0) /
            areas.length,
        };
      });
    const before = await look();
    expect(before.off).toBeLessThan(2e-6);
    // In the page, where it cannot come too late.
    await page.evaluate(async () => {
      const bar = document.querySelector("progress");
      while (bar.value < 0.1) await new Promise(requestAnimationFrame);
      document.querySelector("figure button").click();
      await window.example.done;
    });
    const after = await look();
    const { value } = await page.evaluate(() => ({
      value: document.querySelector("progress").value,
    }));
    expect(value).toBeLessThan(1);
    expect(after.off).toBeLessThan(2e-6);
    expect(after.round).toBeGreaterThan(before.round);
    expect(await look()).toEqual(after);
    expect(page.errors).toEqual([]);
    await closePage(page);
    await inExample(
      "relax",
      async (diagnostics) => (await import(diagnostics)).validate(window.example.diagram),
      (page) => page.waitForFunction(() => document.querySelector("progress").value > 0.1),
    );
  });

  test("facilities: the areas fill the window", async () => {
    const found = await inExample("facilities", () => {
      const { diagram, stations, areas } = window.example;
      const total = stations.reduce(
        (sum, _, id) => sum + (diagram.isHidden(id) ? 0 : areas.cellArea(id)),
        0,
      );
      return {
        total,
        labels: document.querySelectorAll("text").length,
        visible: diagram.visibleSize,
      };
    });
    expect(found.total).toBeCloseTo(920 * 480, 3);
    expect(found.labels).toBeGreaterThan(10);
    expect(found.labels).toBeLessThanOrEqual(found.visible);
  });

  test("temperature: stations have theirs, lakes one all over, the rest is between", async () => {
    const found = await inExample(
      "temperature",
      () => {
        const { stations, at, values } = window.example;
        const rays = [0, 1, 2, 3].map((k) => [0.9 * Math.cos(k), 0.9 * Math.sin(k)]);
        const off = stations.flatMap(({ x, y, r, value }) =>
          rays.map(([dx, dy]) => Math.abs(at(x + dx * r, y + dy * r).value - value)),
        );
        const all = stations.map(({ value }) => value);
        const [low, high] = [Math.min(...all) - 1e-9, Math.max(...all) + 1e-9];
        return {
          isTrue: Math.max(...off) < 1e-6,
          isBetween: values.every((value) => value >= low && value <= high),
          said: document.querySelector("figure text").textContent,
          lines: document.querySelectorAll("figure line").length,
          expected: `${at(300, 200).value.toFixed(1)} °C`,
        };
      },
      async (page) => {
        const { x, y, width } = await page.locator("figure svg").boundingBox();
        await page.mouse.move(x + (300 * width) / 920, y + (200 * width) / 920);
      },
    );
    expect(found).toMatchObject({ isTrue: true, isBetween: true, said: found.expected });
    expect(found.lines).toBeGreaterThan(2);
  });

  test("each example is tested here", () => {
    const text = readFileSync(fileURLToPath(import.meta.url), "utf8");
    expect(names.length).toBe(15);
    for (const name of names) expect(text).toMatch(new RegExp(`inExample\\(\\s*"${name}"`));
  });
});

const kPhone = { viewport: { width: 390, height: 780 }, hasTouch: true, isMobile: true };

const boxOf = (page, selector) =>
  page.$eval(selector, (node) => node.getBoundingClientRect().toJSON());
const meets = (a, b) =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

describeInBrowser("examples on a phone", (open) => {
  const openExample = (name) => open({ ...kPhone, path: `examples/#${name}`, ready: "example" });

  test("a tap on the bubble chart picks", async () => {
    const page = await openExample("bubble_chart");
    const { left, top, width, height } = await boxOf(page, "figure svg");
    const marked = () =>
      page.$$eval("figure circle", (all) =>
        all.findIndex((circle) => circle.getAttribute("fill-opacity") === "0.7"),
      );
    expect(await marked()).toBe(-1);
    await page.touchscreen.tap(left + width / 2, top + height / 2);
    expect(await marked()).toBeGreaterThanOrEqual(0);
    await closePage(page);
  });

  test("labels can be read, and Copy covers no code", async () => {
    const page = await openExample("capacities");
    await page.waitForSelector("figure text");
    const height = await page.$eval("figure text", (text) => text.getBoundingClientRect().height);
    expect(height).toBeGreaterThan(9);
    expect(meets(await boxOf(page, ".code button"), await boxOf(page, ".code pre"))).toBe(false);
    await closePage(page);
  });
});
