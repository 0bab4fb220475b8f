// npm start: sets up, builds the package and the site, and serves it until it is stopped. The site
// is built again when its files change.
//
//   npm start -- --port 8080
//   PORT=8080 npm start
import { spawn } from "node:child_process";
import path from "node:path";
import { buildPackage } from "./build.mjs";
import { watchSite } from "./build_site.mjs";
import { root } from "./toolchain/folders.mjs";
import { main } from "./toolchain/setup.mjs";

await main(async () => {
  await buildPackage();
  const stopWatching = await watchSite();
  const server = spawn(
    process.execPath,
    [path.join(root, "tools/serve.mjs"), ...process.argv.slice(2)],
    { stdio: "inherit" },
  );
  process.on("SIGINT", () => {}); // Ctrl-C reaches the server too; leave when it has
  process.on("SIGTERM", () => server.kill());
  server.on("exit", (code) => {
    stopWatching();
    process.exitCode = code ?? 0;
  });
});
