// Imports 0.mjs, 1.mjs, … of a folder, and prints what they show (examples.mjs):
//
//   node run_examples.mjs FOLDER COUNT
import path from "node:path";
import { pathToFileURL } from "node:url";

function written(value) {
  if (typeof value === "string") return JSON.stringify(value);
  if (Array.isArray(value)) return `[${value.map(written).join(", ")}]`;
  if (ArrayBuffer.isView(value)) return `${value.constructor.name} ${written([...value])}`;
  if (value === null || Object.getPrototypeOf(value) !== Object.prototype) return String(value);
  const members = Object.entries(value).map(([name, member]) => `${name}: ${written(member)}`);
  return `{ ${members.join(", ")} }`;
}

let results;
globalThis.show = async (give, said) => {
  let text;
  try {
    text = written((await give())[0]);
  } catch (error) {
    text = `throws "${typeof error.code === "string" ? error.code : error.name}"`;
  }
  results.push({ said, text });
};

const [folder, count] = process.argv.slice(2);
const outcomes = [];
for (let k = 0; k < Number(count); ++k) {
  results = [];
  const outcome = { results };
  try {
    await import(pathToFileURL(path.join(folder, `${k}.mjs`)));
  } catch (error) {
    outcome.error = error.stack;
  }
  outcomes.push(outcome);
}
console.log(JSON.stringify(outcomes));
