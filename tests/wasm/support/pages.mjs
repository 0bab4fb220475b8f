// Pages in a real browser without a driver: the browser is started with the address of a page that
// holds each case in a frame, and each case reports its result to the server it came from. All run
// under the strictest policy that lets WebAssembly run.
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import path from "node:path";
import { packed } from "./install_packed.mjs";

const policy =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'; " +
  "worker-src 'self'; frame-src 'self'";
const types = { ".js": "text/javascript", ".wasm": "application/wasm", ".html": "text/html" };

// Page and worker scripts find this before their own first line runs.
const report =
  "globalThis.report ??= (found) =>\n" +
  "  fetch(`/report${location.pathname}`, { method: 'POST', body: String(found) });\n" +
  "addEventListener('error', (event) => report(`error: ${event.message}`));\n" +
  "addEventListener('unhandledrejection', (event) => report(`error: ${event.reason}`));\n" +
  "addEventListener('securitypolicyviolation', (event) =>\n" +
  "  report(`policy: ${event.violatedDirective} ${event.blockedURI}`));\n";

/**
 * Serves `cases` and waits until the browser has answered them all.
 * @param {string} browser path of the program
 * @param {Record<string, { charset?: string, hasInline?: boolean, html: string }>} cases pages by
 * name: what follows the script that defines report(found), and whether it has scripts within
 * @param {Record<string, string>} files scripts by name; anything else comes from the folder of the
 * packed package
 * @returns {Promise<Record<string, string>>} what each case reported first
 */
export async function runPages(browser, cases, files, seconds = 300) {
  const results = {};
  let finish;
  const finished = new Promise((resolve) => (finish = resolve));
  const server = createServer((request, response) => {
    const url = new URL(request.url, "http://localhost").pathname;
    const answer = (type, body, allowed = policy) =>
      response
        .writeHead(200, {
          "content-type": type,
          "content-security-policy": allowed,
          "x-content-type-options": "nosniff",
        })
        .end(body);
    if (url.startsWith("/report/")) {
      let body = "";
      request
        .on("data", (chunk) => (body += chunk))
        .on("end", () => {
          results[url.slice("/report/".length)] ??= body;
          if (Object.keys(cases).every((name) => name in results)) finish();
          answer("text/plain", "");
        });
      return;
    }
    const name = url.slice(1);
    if (name === "") {
      return answer(
        "text/html",
        Object.keys(cases)
          .map((key) => `<iframe src="/${key}"></iframe>`)
          .join(""),
      );
    }
    if (name in cases) {
      const { charset = "utf-8", hasInline = false, html } = cases[name];
      return answer(
        `text/html; charset=${charset}`,
        `<!doctype html><script src="/report.js"></script>${html}`,
        hasInline ? policy.replace("'self'", "'self' 'unsafe-inline'") : policy,
      );
    }
    if (name === "report.js") return answer("text/javascript", report);
    if (name in files) return answer("text/javascript", files[name]);
    try {
      answer(
        types[path.extname(name)] ?? "text/plain",
        readFileSync(path.join(packed, path.normalize(name))),
      );
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  const profile = mkdtempSync(path.join(tmpdir(), "apollonius-browser-"));
  const child = launch(browser, profile, `http://127.0.0.1:${server.address().port}/`);
  try {
    let timer;
    await Promise.race([
      finished,
      new Promise((resolve) => (timer = setTimeout(resolve, 1000 * seconds))),
    ]);
    clearTimeout(timer);
    return results;
  } finally {
    await stopped(child);
    server.closeAllConnections();
    await new Promise((resolve) => server.close(resolve));
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

function launch(browser, profile, address) {
  const isFirefox = /firefox/.test(path.basename(browser));
  if (isFirefox) {
    // No first-run pages, no telemetry, no updates: nothing but our page.
    const preferences = {
      "browser.shell.checkDefaultBrowser": false,
      "browser.aboutwelcome.enabled": false,
      "browser.startup.homepage_override.mstone": "ignore",
      "datareporting.policy.dataSubmissionEnabled": false,
      "toolkit.telemetry.reportingpolicy.firstRun": false,
      "app.update.enabled": false,
      "app.normandy.enabled": false,
      "network.captive-portal-service.enabled": false,
      "network.connectivity-service.enabled": false,
    };
    writeFileSync(
      path.join(profile, "user.js"),
      Object.entries(preferences)
        .map(([key, value]) => `user_pref(${JSON.stringify(key)}, ${JSON.stringify(value)});\n`)
        .join(""),
    );
  }
  const args = isFirefox
    ? ["--headless", "--no-remote", "--profile", profile, address]
    : [
        "--headless=new",
        "--no-sandbox",
        "--disable-gpu",
        "--disable-dev-shm-usage",
        "--no-first-run",
        "--disable-background-networking",
        `--user-data-dir=${profile}`,
        address,
      ];
  // A process group of its own, so that the browser's helpers end with it.
  return spawn(browser, args, {
    detached: true,
    stdio: "ignore",
    env: { ...process.env, HOME: profile },
  });
}

function stopped(child) {
  if (child.exitCode !== null || child.pid === undefined) return undefined;
  return new Promise((resolve) => {
    child.on("exit", resolve);
    process.kill(-child.pid, "SIGKILL");
  });
}
