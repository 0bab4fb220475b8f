// A program: diagrams until there is no memory that a module can have (4 GB), then less again.
// Prints what went wrong, or nothing. A process of its own, as that memory is never given back.
import { Diagram } from "../../../build/packed/consumer.mjs";
import { validate } from "../../../build/packed/diagnostics.mjs";

const kSites = 1_000_000;
const wrong = [];
const expect = (holds, what) => holds || wrong.push(what);
const xyr = new Float64Array(3 * kSites);
for (let k = 0, state = 1; k < xyr.length; ++k) {
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  xyr[k] = k % 3 === 2 ? state / 2 ** 32 / 4 : (state / 2 ** 32) * 1000;
}

const diagrams = [];
let code = "none";
while (code === "none" && diagrams.length < 100) {
  try {
    diagrams.push(new Diagram(xyr));
  } catch (error) {
    code = error.code ?? String(error);
  }
}
const gigabytes = process.memoryUsage().arrayBuffers / 2 ** 30;
expect(code === "out-of-memory", `expected out-of-memory, got ${code}`);
expect(
  gigabytes > 3.5 || process.memoryUsage().rss > 3.5 * 2 ** 30,
  `only ${gigabytes.toFixed(1)} GiB were taken`,
);
expect(diagrams.length >= 10, `only ${diagrams.length} diagrams`);

// Nothing more fits; the diagrams answer, and stay as they are when a change fails.
const last = diagrams[diagrams.length - 1];
const size = last.size;
const before = last.find(500, 500);
code = "none";
try {
  for (;;) last.insertMany(xyr);
} catch (error) {
  code = error.code ?? String(error);
}
expect(code === "out-of-memory", `insertMany: expected out-of-memory, got ${code}`);
expect(last.size % size === 0 && diagrams[0].size === size, "a failed change changed a diagram");
expect(last.find(500, 500) === before || last.size > size, "another answer");

// Half of them go; as many come again.
const half = diagrams.length >> 1;
for (const diagram of diagrams.splice(half)) diagram.dispose();
for (let k = 0; k < half - 1; ++k) diagrams.push(new Diagram(xyr));
expect(
  diagrams.every((diagram) => diagram.size === size && diagram.find(500, 500) === before),
  "diagrams differ",
);
expect(validate(diagrams[0]) === null && validate(diagrams.at(-1)) === null, "a diagram is broken");
for (const diagram of diagrams) diagram.dispose();
console.log(JSON.stringify({ wrong, diagrams: diagrams.length, rss: process.memoryUsage().rss }));
