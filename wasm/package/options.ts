// Options as callers give them: an unknown name is probably misspelt.
import { described } from "./arguments.js";
import { ApolloniusError } from "./errors.js";

/** Throws "bad-option" unless these are options, or nothing, and have no other names than these. */
export function checkOptions(options: unknown, ...names: string[]): void {
  if (options === undefined || options === null) return;
  const expected = `expected { ${names.join(", ")} }`;
  const what = described(options);
  if (what !== "an object")
    throw new ApolloniusError("bad-option", `options is ${what}, ${expected}`);
  for (const name of Object.keys(options))
    if (!names.includes(name))
      throw new ApolloniusError("bad-option", `options.${name} is unknown, ${expected}`);
}
