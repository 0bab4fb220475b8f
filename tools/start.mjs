// npm start: sets up, builds the package, and serves the page until it is stopped.
//
//   npm start -- --port 8080
//   PORT=8080 npm start
import { spawn } from "node:child_process";
import path from "node:path";
import { buildPackage } from "./build.mjs";
import { root } from "./toolchain/folders.mjs";
import { main } from "./toolchain/setup.mjs";

await main(async () => {
  await buildPackage();
  const server = spawn(
    process.execPath,
    [path.join(root, "tools/serve.mjs"), ...process.argv.slice(2)],
    { stdio: "inherit" },
  );
  process.on("SIGINT", () => {}); // Ctrl-C reaches the server too; leave when it has
  process.on("SIGTERM", () => server.kill());
  server.on("exit", (code) => {
    process.exitCode = code ?? 0;
  });
});
