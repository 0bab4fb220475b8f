// A static server for the site: node tools/serve.mjs [--port N], or PORT=N in the environment.
// Serves build/web/ as build_site.mjs makes it, at /web/, on this machine only. Where the port is
// taken it says so, and takes the next free one. The headers let pages measure microseconds
// (isolation) and show that the package runs under a strict content security policy (which the
// pages state too).
import { createReadStream } from "node:fs";
import { stat } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize, sep } from "node:path";
import { pathToFileURL } from "node:url";
import { createGzip } from "node:zlib";
import { builtSite } from "./build_site.mjs";

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
  ".jpg": "image/jpeg",
  ".wasm": "application/wasm",
};
/** Recipes, to be read. */
for (const extension of [".cjs", ".jsx", ".md", ".svelte", ".vue"])
  kTypes[extension] = "text/plain; charset=utf-8";
const kHeaders = {
  "Cross-Origin-Opener-Policy": "same-origin",
  "Cross-Origin-Embedder-Policy": "require-corp",
  "Cross-Origin-Resource-Policy": "cross-origin", // Firefox asks for it in sandboxed frames
  "X-Content-Type-Options": "nosniff",
};

/** The file that a request is for, and its size, if there is one. */
async function fileFor(url) {
  let path;
  try {
    path = normalize(decodeURIComponent(new URL(url, "http://localhost").pathname));
  } catch {
    return null;
  }
  const parts = path.split(sep).filter(Boolean);
  const [top, ...rest] = path.endsWith(sep) ? [...parts, "index.html"] : parts;
  if (top !== "web" || parts.some((part) => part.startsWith("."))) return null;
  const file = join(builtSite, ...rest);
  const found = await stat(file).catch(() => null);
  return found?.isFile() ? { file, size: found.size } : null;
}

const isText = (type) => /^text|json|svg|wasm/.test(type);

async function answer(request, response, { caching, isCompressing }) {
  const refuse = (status, text) =>
    response.writeHead(status, { "Content-Type": "text/plain" }).end(`${text}\n`);
  if (request.method !== "GET" && request.method !== "HEAD")
    return refuse(405, "Only GET and HEAD.");
  if (/^\/(web)?(\?.*)?$/.test(request.url))
    return response.writeHead(302, { Location: "/web/" }).end();
  const found = await fileFor(request.url);
  if (!found) return refuse(404, "Not found.");
  const type = kTypes[extname(found.file)] ?? "application/octet-stream";
  const isCompressed = isCompressing && isText(type);
  response.writeHead(200, {
    ...kHeaders,
    "Cache-Control": caching,
    "Content-Type": type,
    ...(isCompressed ? { "Content-Encoding": "gzip" } : { "Content-Length": found.size }),
  });
  if (request.method === "HEAD") return response.end();
  const bytes = createReadStream(found.file).on("error", () => response.destroy());
  return (isCompressed ? bytes.pipe(createGzip()) : bytes).pipe(response);
}

/**
 * Starts the server on the first free port from `port` on (0: any). The site has been built.
 * @param {{ attempts?: number, caching?: string, isCompressing?: boolean }} [options] what
 * browsers are told to keep: by default nothing unasked, as files change; whether texts are
 * compressed, as on the web
 * @returns {Promise<{ url: string, close(): Promise<void> }>}
 */
export async function serve(port = 8080, options = {}) {
  const { attempts = 50, caching = "no-cache", isCompressing = false } = options;
  const server = createServer((request, response) => {
    answer(request, response, { caching, isCompressing }).catch(() => response.destroy());
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
  if (!(await stat(builtSite).catch(() => null))) {
    console.error("build/web/ is missing: the site has not been built. Run: npm start");
    process.exit(1);
  }
  const { url } = await serve(port);
  if (port !== 0 && new URL(url).port !== String(port)) console.log(`Port ${port} is taken.`);
  console.log(`The page is at ${url}  (Ctrl-C ends it)`);
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href)
  await main(process.argv.slice(2));
