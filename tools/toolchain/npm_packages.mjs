// node_modules as package-lock.json says.
import { createHash } from "node:crypto";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { root } from "./folders.mjs";
import { run, say } from "./process.mjs";

/** Runs `npm ci` unless the lock file is the one that the last `npm ci` was run for. */
export function ensureNpmPackages() {
  const stamp = path.join(root, "node_modules/.apollonius-lock");
  const hash = createHash("sha256")
    .update(readFileSync(path.join(root, "package-lock.json")))
    .digest("hex");
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === hash) return;
  say("npm ci");
  run("npm", ["ci", "--no-audit", "--no-fund", "--loglevel=error"], { cwd: root });
  writeFileSync(stamp, hash);
}
