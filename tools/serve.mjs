// A static server for the page: node tools/serve.mjs [--port N], or PORT=N in the environment.
// Serves the page as build_page.mjs makes it, which it does first, and again when the page's
// modules change; web/examples and their data; dist/ and the d3 modules that the examples import.
// On this machine only. Where the port is taken it says so, and takes the next free one. The
// headers let the page measure microseconds (isolation) and show that the package runs under a
// strict content security policy (which index.html states too).
import { createReadStream } from "node:fs";
import { stat } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize, sep } from "node:path";
import { pathToFileURL } from "node:url";
import { buildPage, builtPage, watchPage } from "./build_page.mjs";
import { root } from "./toolchain/folders.mjs";

const kServedFolders = ["examples", "data"]; // of web/, as they are
const kServedPackages = /^d3-\w+$/; // of node_modules: what web/examples imports
const kHost = "127.0.0.1";
const kTypes = {
  ".html": "text/html; charset=utf-8",
  ".css": "text/css; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".mjs": "text/javascript; charset=utf-8",
  ".json": "application/json; charset=utf-8",
  ".map": "application/json; charset=utf-8",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".wasm": "application/wasm",
};
const kHeaders = {
  "Cross-Origin-Opener-Policy": "same-origin",
  "Cross-Origin-Embedder-Policy": "require-corp",
  "X-Content-Type-Options": "nosniff",
};

/** Where the file that a request is for may be, in order. */
function filesFor(url) {
  let path;
  try {
    path = normalize(decodeURIComponent(new URL(url, "http://localhost").pathname));
  } catch {
    return [];
  }
  const parts = path.split(sep).filter(Boolean);
  if (parts.some((part) => part.startsWith("."))) return [];
  const [top, ...rest] = path.endsWith(sep) ? [...parts, "index.html"] : parts;
  const asItIs = join(root, top, ...rest);
  if (top === "web") {
    const isOfExamples = kServedFolders.includes(rest[0]);
    return [join(builtPage, ...rest), ...(isOfExamples ? [asItIs] : [])];
  }
  const isServed = top === "dist" || (top === "node_modules" && kServedPackages.test(rest[0]));
  return isServed ? [asItIs] : [];
}

/** The first of these files that is there. */
async function firstOf(files) {
  for (const file of files) {
    const found = await stat(file).catch(() => null);
    if (found?.isFile()) return { file, size: found.size };
  }
  return null;
}

async function answer(request, response, caching) {
  const refuse = (status, text) =>
    response.writeHead(status, { "Content-Type": "text/plain" }).end(`${text}\n`);
  if (request.method !== "GET" && request.method !== "HEAD")
    return refuse(405, "Only GET and HEAD.");
  if (/^\/(web)?(\?.*)?$/.test(request.url))
    return response.writeHead(302, { Location: "/web/" }).end();
  const found = await firstOf(filesFor(request.url));
  if (!found) return refuse(404, "Not found.");
  response.writeHead(200, {
    ...kHeaders,
    "Cache-Control": caching,
    "Content-Type": kTypes[extname(found.file)] ?? "application/octet-stream",
    "Content-Length": found.size,
  });
  if (request.method === "HEAD") return response.end();
  return createReadStream(found.file)
    .on("error", () => response.destroy())
    .pipe(response);
}

/**
 * Builds the page, and starts the server on the first free port from `port` on (0: any).
 * @param {{ attempts?: number, caching?: string, isWatching?: boolean }} [options] what browsers
 * are told to keep: by default nothing unasked, as files change; whether the page is built again
 * when they do
 * @returns {Promise<{ url: string, close(): Promise<void> }>}
 */
export async function serve(port = 8080, options = {}) {
  const { attempts = 50, caching = "no-cache", isWatching = false } = options;
  const stopBuilding = await (isWatching ? watchPage() : buildPage());
  const server = createServer((request, response) => {
    answer(request, response, caching).catch(() => response.destroy());
  });
  for (let k = 0; ; k++) {
    try {
      await new Promise((resolve, reject) => {
        server.once("error", reject);
        server.listen(port === 0 ? 0 : port + k, kHost, () => {
          server.off("error", reject);
          resolve();
        });
      });
      break;
    } catch (error) {
      if (error.code !== "EADDRINUSE" || k + 1 >= attempts) throw error;
    }
  }
  const url = `http://localhost:${server.address().port}/web/`;
  const close = async () => {
    await stopBuilding?.();
    await new Promise((resolve) => {
      server.close(resolve);
      server.closeAllConnections();
    });
  };
  return { url, close };
}

async function main(args) {
  const at = args.indexOf("--port");
  const port = Number(at < 0 ? process.env.PORT || 8080 : args[at + 1]);
  if (!Number.isInteger(port) || port < 0 || port > 65535) {
    console.error("usage: node tools/serve.mjs [--port N], or PORT=N, from 0 to 65535");
    process.exit(2);
  }
  if (!(await stat(join(root, "dist")).catch(() => null))) {
    console.error(
      "dist/ is missing: the package has not been built. Run: npm start (or npm run build)",
    );
    process.exit(1);
  }
  const { url } = await serve(port, { isWatching: true });
  if (port !== 0 && new URL(url).port !== String(port)) console.log(`Port ${port} is taken.`);
  console.log(`The page is at ${url}  (Ctrl-C ends it)`);
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href)
  await main(process.argv.slice(2));
