// The recipe for Observable Framework: a page that it builds from the packed package, offline, in
// the browser.
import { cpSync, mkdirSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { afterAll, beforeAll, expect, test } from "@jest/globals";
import { root } from "../../tools/toolchain/folders.mjs";
import { capture } from "../../tools/toolchain/process.mjs";
import { packed } from "../wasm/support/install_packed.mjs";
import { describeInBrowser } from "../web/support/browser.mjs";

const project = path.join(packed, "observable_framework");
const dist = path.join(project, "dist");
const program = "tests/strangers/node_modules/@observablehq/framework/dist/bin/observable.js";

/**
 * Framework asks a CDN for the versions of packages that a page might load from there, although
 * this one loads nothing. A folder for each package in its cache gives the answer.
 */
const kAskedFor =
  "@observablehq/inputs @observablehq/plot @observablehq/sample-datasets apache-arrow arquero d3 " +
  "d3-dsv echarts htl leaflet lodash mapbox-gl parquet-wasm react react-dom topojson-client";

function buildPage() {
  rmSync(project, { recursive: true, force: true });
  for (const name of kAskedFor.split(" "))
    mkdirSync(path.join(project, `src/.observablehq/cache/_npm/${name}@1.0.0`), {
      recursive: true,
    });
  cpSync(
    path.join(root, "web/examples/observable_framework.md"),
    path.join(project, "src/index.md"),
  );
  writeFileSync(
    path.join(project, "observablehq.config.js"),
    'export default { root: "src", theme: [], globalStylesheets: [], pager: false };\n',
  );
  const env = { NODE_OPTIONS: "", OBSERVABLE_TELEMETRY_DISABLE: "true" };
  capture(process.execPath, [path.join(root, program), "build"], { cwd: project, env });
}

const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css" };

describeInBrowser("Observable Framework", (open) => {
  let server;
  beforeAll(async () => {
    buildPage();
    server = createServer(async (request, response) => {
      const { pathname } = new URL(request.url, "http://localhost");
      if (pathname === "/favicon.ico") return response.writeHead(204).end();
      const file = path.join(dist, pathname === "/" ? "index.html" : pathname);
      const body = await readFile(file).catch(() => null);
      response.writeHead(body ? 200 : 404, { "Content-Type": types[path.extname(file)] ?? "" });
      response.end(body);
    });
    await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
  });
  afterAll(() => server?.close());

  test("the page has the package, and its cells run again with the pointer", async () => {
    expect(readdirSync(path.join(dist, "_node"))[0]).toMatch(/^apollonius-diagram/);
    const site = `http://127.0.0.1:${server.address().port}/`;
    const page = await open({ site, path: "?", ready: null });
    const said = (text) => page.locator(`p:has-text("bubble ${text}.")`).waitFor();
    await said("-1");
    const box = await page.locator("canvas").boundingBox();
    await page.mouse.move(box.x + 137.5, box.y + 89.3);
    await said("1");
    mkdirSync(path.join(root, "build/pictures"), { recursive: true });
    await page.screenshot({ path: path.join(root, "build/pictures/recipe_framework.png") });
    expect(page.errors).toEqual([]);
  });
});
