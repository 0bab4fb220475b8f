// A JavaScript contender as a program: reads one request a line, answers each with one line of
// JSON, as bench/native/contender.h.
//
//   node bench/js/contender.mjs NAME                        requests from standard input
//   node bench/js/contender.mjs NAME SET OPERATION...       for a person
//
// NAME is ours, delaunator, d3_delaunay, d3_voronoi_map, d3_geo_voronoi, d3_voronoi_treemap or
// flatbush. `ours` loads the packed package from the folder in BENCH_PACKAGE.
import { createInterface } from "node:readline";

function parsed(line) {
  const words = Object.fromEntries(line.split(" ").map((word) => word.split(/=(.*)/s)));
  const { op, set, count = 0, seconds = 0.2, limit = 60, step = 0.01 } = words;
  return { operation: op, set, count: +count, seconds: +seconds, limit: +limit, step: +step };
}

const [name, set, ...people] = process.argv.slice(2);
const { operations, warmUp } = await import(`./${name}.mjs`);

async function answer(request) {
  const operation = operations[request.operation];
  if (!operation) return { error: `unknown operation ${request.operation}` };
  try {
    return await operation(request);
  } catch (error) {
    return { error: String(error.message ?? error) };
  }
}

warmUp?.();
if (people.length > 0) {
  for (const operation of people) {
    const { samples, error, ...rest } = await answer({
      operation,
      set,
      count: 0,
      seconds: 1,
      limit: 60,
      step: 0.01,
    });
    const sorted = samples?.toSorted((a, b) => a - b).map((time) => time.toFixed(4));
    const text = error ?? `${sorted[sorted.length >> 1]} us  (${sorted[0]} .. ${sorted.at(-1)})`;
    console.log(operation.padEnd(14), text, JSON.stringify(rest));
  }
} else {
  for await (const line of createInterface({ input: process.stdin }))
    console.log(JSON.stringify(await answer(parsed(line))));
}
