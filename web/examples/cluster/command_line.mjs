// What the programs have in common: options, --help, and errors of one sentence with exit code 1.
import path from "node:path";
import { getSystemErrorMap, parseArgs } from "node:util";

/** An error in words: of a file, its name and what is wrong with it; never empty. */
export function wordsOf({ message, code, errno, path: file, errors = [] }) {
  const [, description] = getSystemErrorMap().get(errno) ?? [];
  if (file && description) return `${file}: ${description}`;
  return message || errors.map(wordsOf).join(", ") || code; // ioredis has some without a message
}

/**
 * The options on the command line. `options` is as for `parseArgs`, and may say `required: true`,
 * and what a text stands for: `as(text, name)`, which throws what it should have been. `--help`
 * prints the usage and ends the program. From here on, whatever nobody catches ends it, too.
 */
export function readOptions(usage, options) {
  process.on("uncaughtException", (error) => {
    console.error(wordsOf(error));
    process.exit(1);
  });
  const program = path.basename(process.argv[1]);
  try {
    const { values } = parseArgs({
      options: { ...options, help: { type: "boolean", short: "h" } },
    });
    if (values.help) {
      console.log(usage.trim());
      process.exit();
    }
    for (const [name, { required, as }] of Object.entries(options)) {
      if (required && !values[name]) throw new Error(`--${name} is missing`);
      if (as && values[name] !== undefined) values[name] = as(values[name], name);
    }
    return values;
  } catch ({ message }) {
    throw new Error(`${message}\n\`node ${program} --help\` says what it takes.`);
  }
}

export function count(text, name) {
  const value = Number(text);
  if (Number.isSafeInteger(value) && value > 0) return value;
  throw new Error(`--${name} is a whole number from 1 on, not ${text}`);
}

export function seconds(text, name) {
  const value = Number(text);
  if (text !== "" && value > 0 && value < 2 ** 31 / 1000) return value;
  throw new Error(`--${name} is a number of seconds, not ${text}`);
}

const names = (words, count) => (text, name) => {
  const found = text.split(",");
  if (found.length === count) return found;
  throw new Error(`--${name} is ${words} names with a comma between, not ${text}`);
};
export const twoColumns = names("two", 2);
export const threeColumns = names("three", 3);

export function rectangle(text, name) {
  const [xmin, ymin, xmax, ymax, ...more] = text.split(",").map((side) => Number(side || NaN));
  if (xmin < xmax && ymin < ymax && [xmin, ymin, xmax, ymax].every(Number.isFinite) && !more.length)
    return [xmin, ymin, xmax, ymax];
  throw new Error(`--${name} is xmin,ymin,xmax,ymax, not ${text}`);
}
