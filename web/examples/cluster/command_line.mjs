// Shared by the programs: options, --help, and errors of one sentence with exit code 1.
import path from "node:path";
import { getSystemErrorMap, parseArgs } from "node:util";

/** An error in words: of a file, its name and what is wrong with it; never empty. */
export function wordsOf({ message, code, errno, path: file, errors = [] }) {
  const [, description] = getSystemErrorMap().get(errno) ?? [];
  if (file && description) return `${file}: ${description}`;
  return message || errors.map(wordsOf).join(", ") || code; // ioredis has some without a message
}

/** The Redis of REDIS_URL, which all machines reach; undefined without it. */
export function givenRedis() {
  const url = process.env.REDIS_URL;
  if (url?.includes("://") && !URL.canParse(url))
    throw new Error("REDIS_URL cannot be read: it is like redis://:password@host:6379");
  return url || undefined;
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

export function positive(text, name) {
  const value = Number(text);
  if (value > 0 && Number.isFinite(value)) return value;
  throw new Error(`--${name} is a number above 0, not ${text}`);
}

/** Options that submit and build have in common: where their workers are. */
export const runOptions = {
  workers: {
    type: "string",
    as(text, name) {
      if (givenRedis()) throw new Error(`--${name} is for one machine: there is a REDIS_URL`);
      return count(text, name);
    },
  },
  patience: { type: "string", default: "20", as: seconds },
};
export const whereItRuns = `
  --workers     workers on this machine, by default one for each processor
  --patience    seconds without an answer of Redis after which it gives up, by default 20

Without REDIS_URL it does all on this machine: it starts a Redis and workers, which end with it.
REDIS_URL names a Redis that other machines reach, too; then worker.mjs is started by hand, on each
of them.`.trimStart();

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
