// Redis, for the tests of web/examples/cluster.
import { candidate, ensureInstalled, hasApt } from "./apt.mjs";
import { say, which } from "./process.mjs";

/** The path of redis-server, installed if need be; null if it cannot be had. */
export function ensureRedis() {
  const found = () => which("redis-server");
  if (found()) return found();
  try {
    if (hasApt() && candidate("redis-server") !== null)
      ensureInstalled(["redis-server"], "the tests of the cluster example");
  } catch (error) {
    say(error.message);
  }
  return found();
}
