// The static server: types, refusals, the next free port; the files of the page when it is served,
// and its security policy.
import { spawn } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import { createServer, request } from "node:http";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { afterAll, beforeAll, expect, test } from "@jest/globals";
import { builtSite } from "../../tools/build_site.mjs";
import { serve } from "../../tools/serve.mjs";
import { closePage, describeInBrowser } from "./support/browser.mjs";

let server;
beforeAll(async () => (server = await serve(0)));
afterAll(() => server.close());

/** The status and headers for a path that is sent as it is. */
const get = (path, method = "GET") =>
  new Promise((resolve, reject) => {
    const { port } = new URL(server.url);
    request({ host: "127.0.0.1", port, path, method }, (response) => {
      response.resume();
      response.on("end", () => resolve({ status: response.statusCode, headers: response.headers }));
    })
      .on("error", reject)
      .end();
  });

/** The name of a file that Vite has made. */
const asset = (pattern) =>
  readdirSync(path.join(builtSite, "assets")).find((name) => pattern.test(name));

test.each([
  ["/web/", "text/html"],
  ["/web/why/", "text/html"],
  ["/web/reference/api/", "text/html"],
  ["/web/playground/", "text/html"],
  ["/web/shared/random_sets.js", "text/javascript"],
  ["/web/icon.svg", "image/svg+xml"],
  ["/web/data/cities.json", "application/json"],
  ["/web/data/country.json", "application/json"],
  ["/web/examples/", "text/html"],
  ["/web/examples/globe.html", "text/html"],
  ["/web/examples/gallery.js", "text/javascript"],
  ["/web/lib/apollonius-diagram/sphere.js", "text/javascript"],
  ["/web/lib/d3-force.mjs", "text/javascript"],
  [`/web/assets/${asset(/^core.*\.wasm$/)}`, "application/wasm"],
  [`/web/assets/${asset(/^build_worker.*\.js$/)}`, "text/javascript"],
  [`/web/assets/${asset(/^playground.*\.css$/)}`, "text/css"],
  [`/web/assets/${asset(/^playground.*\.js\.map$/)}`, "application/json"],
])("%s is %s, isolated", async (path, type) => {
  const { status, headers } = await get(path);
  expect(status).toBe(200);
  expect(headers["content-type"]).toContain(type);
  expect(headers["cross-origin-opener-policy"]).toBe("same-origin");
  expect(headers["cross-origin-embedder-policy"]).toBe("require-corp");
});

test.each([
  "/package.json",
  "/web/../package.json",
  "/web/%2e%2e/package.json",
  "/web/%2e%2e%2fpackage.json",
  "/web/none.js",
  "/web/playground/app.js",
  "/web/playground/sets/presets.js",
  "/web/tsconfig.json",
  "/web/data/",
  "/build/web/index.html",
])("%s is refused", async (path) => {
  expect((await get(path)).status).toBe(404);
});

test("the root leads to the page, a folder's name to its page", async () => {
  expect(await get("/")).toMatchObject({ status: 302, headers: { location: "/web/" } });
  expect(await get("/web/why")).toMatchObject({ status: 302, headers: { location: "/web/why/" } });
  expect((await get("/web/", "HEAD")).status).toBe(200);
});

test("a port in use is passed over", async () => {
  const taken = createServer();
  await new Promise((resolve) => taken.listen(0, "127.0.0.1", resolve));
  const { port } = taken.address();
  const second = await serve(port);
  expect(Number(new URL(second.url).port)).toBeGreaterThan(port);
  await second.close();
  await new Promise((resolve) => taken.close(resolve));
});

/** Returns what the program prints first, when it is started like this. */
const started = (args, env) =>
  new Promise((resolve, reject) => {
    const program = fileURLToPath(new URL("../../tools/serve.mjs", import.meta.url));
    const child = spawn(process.execPath, [program, ...args], {
      env: { ...process.env, ...env },
    });
    let said = "";
    const hear = (text) => {
      said += text;
      if (!/The page is at|usage/.test(said)) return;
      child.kill();
      resolve(said);
    };
    child.stdout.on("data", hear);
    child.stderr.on("data", hear);
    child.on("error", reject);
  });

test("the port comes from --port or PORT; a taken one is said, and the next one used", async () => {
  const taken = createServer();
  await new Promise((resolve) => taken.listen(0, "127.0.0.1", resolve));
  const { port } = taken.address();
  for (const said of await Promise.all([
    started([], { PORT: String(port) }),
    started(["--port", String(port)], {}),
  ])) {
    expect(said).toContain(`Port ${port} is taken.`);
    expect(Number(said.match(/localhost:(\d+)/)[1])).toBeGreaterThan(port);
  }
  expect(await started([], { PORT: "none" })).toMatch(/usage/);
  await new Promise((resolve) => taken.close(resolve));
});

test("the security policy allows no inline script, and the page contains no such script", () => {
  const html = readFileSync(new URL("../../web/playground/index.html", import.meta.url), "utf8");
  const policy = html.match(/content="(default-src[^"]*)"/)[1];
  expect(policy).toMatch(/script-src 'self' 'wasm-unsafe-eval';/);
  expect(policy).not.toMatch(/unsafe-(inline|eval|hashes)(?<!wasm-unsafe-eval)/);
  expect(html.match(/<script[^>]*>[^<]*/g)).toEqual(['<script type="module" src="main.ts">']);
});

describeInBrowser("the page as it is served", (open) => {
  test("comes with at most ten requests, all below the site's folder", async () => {
    const asked = [];
    const page = await open({
      prepare: (page) => page.on("request", (request) => asked.push(request.url())),
    });
    const folder = new URL("..", page.url()).href;
    expect(asked.filter((url) => !url.startsWith(folder))).toEqual([]);
    expect(new Set(asked).size).toBeLessThanOrEqual(10);
    // Later: cities, land, and a worker.
    await page.evaluate(() => app.whenFetched);
    const others = asked.filter((url) => !/\.json$|_worker-[\w-]+\.js$/.test(url));
    expect(new Set(others).size).toBeLessThanOrEqual(10);
    expect(page.errors).toEqual([]);
    await closePage(page);
  });
});

test("the built site has no file of an earlier build", () => {
  const built = readdirSync(path.join(builtSite, "assets"));
  expect(built.filter((name) => /^playground-[\w-]+\.js$/.test(name))).toHaveLength(1);
});
