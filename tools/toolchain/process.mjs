// Runs other programs, and prints the current step.
import { spawnSync } from "node:child_process";
import { accessSync, constants } from "node:fs";
import path from "node:path";

/** A failure that the user can act on: printed without a stack trace. */
export class SetUpError extends Error {}

export function say(text) {
  console.log(`\x1b[2m[set-up]\x1b[0m ${text}`);
}

/** Runs a program with its output shown; throws if it fails. */
export function run(program, args, { cwd, env } = {}) {
  const { status, error, signal } = spawnSync(program, args, {
    cwd,
    env: { ...process.env, ...env },
    stdio: "inherit",
  });
  if (error) throw new SetUpError(`${program} cannot be run: ${error.message}`);
  if (status !== 0)
    throw new SetUpError(`failed (${signal ?? `exit ${status}`}): ${program} ${args.join(" ")}`);
}

/** Runs a program and returns its output; shows the output only if it fails. */
export function capture(program, args, { cwd, env } = {}) {
  const { status, error, stdout, stderr } = spawnSync(program, args, {
    cwd,
    env: { ...process.env, ...env },
    encoding: "utf8",
    maxBuffer: 1 << 28,
    stdio: ["ignore", "pipe", "pipe"],
  });
  if (error) throw new SetUpError(`${program} cannot be run: ${error.message}`);
  if (status !== 0)
    throw new SetUpError(
      `failed (exit ${status}): ${program} ${args.join(" ")}\n${stdout}${stderr}`,
    );
  return stdout;
}

/** Does a program end well? Shows no output. */
export function succeeds(program, args, options = {}) {
  return spawnSync(program, args, { ...options, stdio: "ignore" }).status === 0;
}

/** The path of a program on PATH, or null. */
export function which(program) {
  for (const folder of (process.env.PATH ?? "").split(path.delimiter)) {
    const file = path.join(folder, program);
    try {
      accessSync(file, constants.X_OK);
      return file;
    } catch {
      // Not in this folder.
    }
  }
  return null;
}
