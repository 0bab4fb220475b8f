// A static server for the site: node tools/serve.mjs [--port N], or PORT=N in the environment.
// Serves build/web/ as build_site.mjs makes it, at /web/, on this machine only. Where the port is
// taken it says so, and takes the next free one. The headers let pages measure microseconds
// (isolation) and show that the package runs under a strict content security policy (which the
// pages state too).
import { once } from "node:events";
import { existsSync } from "node:fs";
import { createServer } from "node:http";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { builtSite } from "./build_site.mjs";
import { SetUpError } from "./toolchain/process.mjs";
import { main } from "./toolchain/setup.mjs";

const kHeaders = {
  "Cross-Origin-Opener-Policy": "same-origin",
  "Cross-Origin-Embedder-Policy": "require-corp",
  "Cross-Origin-Resource-Policy": "cross-origin", // Firefox asks for it in sandboxed frames
  "X-Content-Type-Options": "nosniff",
};
/** Programs, to be read: browsers would download most of these. */
const kPrograms = /\.(cjs|jsx|md|svelte|vue)$/;

/**
 * Starts the server on the first free port from `port` on (0: any). The site has been built.
 * @param {{ caching?: string }} [options] what browsers are told to keep: by default nothing
 * unasked, as files change
 * @returns {Promise<{ url: string, close(): Promise<void> }>}
 */
export async function serve(port = 8080, { caching = "no-cache" } = {}) {
  const { default: sirv } = await import("sirv"); // not before `npm ci` may have installed it
  const setHeaders = (response, path) => {
    response.setHeaders(new Map(Object.entries({ ...kHeaders, "Cache-Control": caching })));
    if (kPrograms.test(path)) response.setHeader("Content-Type", "text/plain;charset=utf-8");
    if (/\.m?js$/.test(path)) response.setHeader("Content-Type", "text/javascript;charset=utf-8");
  };
  const answer = sirv(builtSite, { dev: true, setHeaders });
  const server = createServer((request, response) => {
    const [path] = request.url.split("?");
    const goTo = (Location) => response.writeHead(302, { Location }).end();
    if (path === "/" || path === "/web") return goTo("/web/");
    if (!path.startsWith("/web/")) return response.writeHead(404).end();
    if (!/\/$|\.\w+$/.test(path)) return goTo(`${path}/`); // a folder
    request.url = request.url.slice("/web".length);
    answer(request, response);
  });
  for (let isListening = false; !isListening; port++) {
    server.listen(port, "127.0.0.1");
    isListening = await once(server, "listening").catch((error) => {
      if (error.code !== "EADDRINUSE") throw error;
    });
  }
  const close = async () => {
    server.close();
    server.closeAllConnections();
    await once(server, "close");
  };
  return { url: `http://localhost:${server.address().port}/web/`, close };
}

/** Serves the site on the port that the command line or the environment names. */
export async function serveSite() {
  const { values } = parseArgs({ options: { port: { type: "string" } } });
  const port = Number(values.port ?? (process.env.PORT || 8080));
  if (!(port >= 0 && port < 65536))
    throw new SetUpError("usage: node tools/serve.mjs [--port N], or PORT=N, from 0 to 65535");
  if (!existsSync(builtSite))
    throw new SetUpError("build/web/ is missing: the site has not been built. Run: npm start");
  const { url } = await serve(port);
  if (port !== 0 && new URL(url).port !== String(port)) console.log(`Port ${port} is taken.`);
  console.log(`The page is at ${url}  (Ctrl-C ends it)`);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) await main(serveSite);
