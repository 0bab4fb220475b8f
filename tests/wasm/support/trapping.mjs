// A program that examines what calls leave behind when they end in their middle. The module's own
// functions are wrapped before its first use, so that a chosen one really traps in WebAssembly,
// with the module's stack in use. Prints its findings as JSON. It is a process of its own, as it
// replaces WebAssembly.Instance.
import { Diagram } from "../../../build/packed/consumer.mjs";
import { validate } from "../../../build/packed/diagnostics.mjs";
import { isThorough } from "../../support/effort.mjs";
import { calls } from "./calls.mjs";
import { snapshot } from "./graph.mjs";
import { randomCircles } from "./random.mjs";

// (module (memory 1) (func (export "a") unreachable) (func (export "b") (drop (i32.load8_u
// (i32.const -1)))) (func (export "c") (call 2)))
const trapper = new WebAssembly.Instance(
  new WebAssembly.Module(
    Uint8Array.of(
      0,
      97,
      115,
      109,
      1,
      0,
      0,
      0,
      1,
      4,
      1,
      96,
      0,
      0,
      3,
      4,
      3,
      0,
      0,
      0,
      5,
      3,
      1,
      0,
      1,
      7,
      13,
      3,
      1,
      97,
      0,
      0,
      1,
      98,
      0,
      1,
      1,
      99,
      0,
      2,
      10,
      19,
      3,
      3,
      0,
      0,
      11,
      8,
      0,
      65,
      127,
      45,
      0,
      0,
      26,
      11,
      4,
      0,
      16,
      2,
      11,
    ),
  ),
).exports;
const traps = { unreachable: trapper.a, "out of bounds": trapper.b, "end of stack": trapper.c };

let seen = 0; // calls about diagrams
let trapAt = 0; // which of these traps; 0 for none
let trapsInGrow = false;
let trap = traps.unreachable;
const started = [];
const destroyed = [];

const RealInstance = WebAssembly.Instance;
WebAssembly.Instance = class {
  constructor(module, imports) {
    if (imports.core) {
      // another part, which works in the first one's memory and table
      const { real } = started.find(({ shown }) => shown === imports.core);
      this.exports = new RealInstance(module, { core: real }).exports;
      return;
    }
    const { env } = imports;
    const invokers = new Map(); // the functions that Embind calls, by their numbers in the table
    const registering = (name, position, kind) => ({
      [name](...values) {
        invokers.set(values[position] >>> 0, kind);
        env[name](...values);
      },
    });
    const observed = {
      ...env,
      ...registering("_embind_register_class", 12, "destructor"),
      ...registering("_embind_register_class_constructor", 4, "call"),
      ...registering("_embind_register_class_function", 5, "call"),
      ...registering("_embind_register_function", 4, "call"),
      emscripten_resize_heap(bytes) {
        if (!trapsInGrow) return env.emscripten_resize_heap(bytes);
        trapsInGrow = false;
        return trap(); // in the middle of malloc, in the middle of the call
      },
    };
    const real = new RealInstance(module, { ...imports, env: observed }).exports;
    const table = real.__indirect_function_table;
    const get = (number) => {
      const plain = table.get(number);
      const kind = invokers.get(number);
      if (kind === undefined) return plain;
      return (...values) => {
        if (kind === "destructor") destroyed.push(values[0]);
        else if (++seen === trapAt) {
          real._emscripten_stack_restore(real.emscripten_stack_get_current() - 1000);
          trap();
        }
        return plain(...values);
      };
    };
    this.exports = { ...real, __indirect_function_table: { get } };
    started.push({ real, env, shown: this.exports });
  }
};

const build = () => {
  const diagram = new Diagram(randomCircles(40, 51));
  diagram.insert(0, 0, 300);
  return diagram;
};

function codeOf(call) {
  try {
    call();
    return "none";
  } catch (error) {
    return error.code ?? String(error);
  }
}

/** Returns what a call throws, or its promise is rejected with; undefined for none. */
async function errorOf(call) {
  try {
    await call();
  } catch (error) {
    return error;
  }
}

const bystander = build();
const before = snapshot(bystander);
const top = started[0].real.emscripten_stack_get_current();

/** Says what is wrong with all the others; "" if nothing is. */
function harm() {
  if (started.some(({ real }) => real.emscripten_stack_get_current() !== top)) return "stack";
  if (snapshot(bystander) !== before || validate(bystander) !== null) return "bystander";
  const id = bystander.insert(1, 2, 3);
  bystander.remove(id);
  const fresh = build();
  const wrong = snapshot(fresh) !== before || validate(fresh) !== null;
  fresh.dispose();
  return wrong ? "a new diagram" : "";
}

const isMaking = (name) => /\.(constructor|from|fromBytes)$/.test(name);

/** Returns the codes that the calls of a broken diagram throw. */
async function codesAfter(diagram, view) {
  const codes = new Set();
  for (const [name, { use }] of calls) {
    if (isMaking(name) || name === "Diagram.voronoi") continue;
    const it = name.startsWith("Voronoi.") ? { voronoi: () => view } : diagram;
    const error = await errorOf(() => use(it));
    codes.add(error === undefined ? "none" : (error.code ?? String(error)));
  }
  return [...codes].sort();
}

const perCall = {};
for (const [name, { use }] of calls) {
  const copy = build();
  seen = 0;
  await use(copy);
  const steps = seen;
  copy.dispose();
  const found = [];
  for (const kind in traps) {
    for (const step of new Set([1, 2, steps].filter((step) => step >= 1 && step <= steps))) {
      const diagram = build(),
        view = diagram.voronoi();
      [seen, trapAt, trap] = [0, step, traps[kind]];
      const error = await errorOf(() => use(diagram));
      trapAt = 0;
      const after = isMaking(name) ? null : await codesAfter(diagram, view);
      const destructions = destroyed.length;
      diagram.dispose();
      const destructed = isMaking(name) ? 0 : destroyed.length - destructions;
      found.push({
        kind,
        step,
        code: error?.code,
        cause: error?.cause?.name,
        after,
        destructed,
        disposed: codeOf(() => diagram.size),
        harm: harm(),
      });
    }
  }
  perCall[name] = found;
}

// In the middle of real calls, where the memory has to grow.
const large = randomCircles(30_000, 52);
const largeBytes = (() => {
  const diagram = new Diagram(large);
  const bytes = diagram.toBytes();
  diagram.dispose();
  return bytes;
})();
const growing = {
  constructor: () => new Diagram(large),
  fromBytes: () => Diagram.fromBytes(largeBytes),
  insertMany: (diagram) => diagram.insertMany(large),
  insert: (diagram) => {
    for (;;) diagram.insert(Math.random(), Math.random(), 0);
  },
  findMany: (diagram) => diagram.findMany(new Float64Array(4_000_000)),
};
const inGrowth = Object.entries(growing).flatMap(([name, use]) =>
  Object.keys(traps).map((kind) => {
    const diagram = build();
    trap = traps[kind];
    trapsInGrow = true;
    const keep = [];
    let code = "none";
    for (let k = 0; k < 100 && trapsInGrow; ++k) code = codeOf(() => keep.push(use(diagram)));
    trapsInGrow = false;
    return { name, kind, code, harm: harm() };
  }),
);

// A context's own exception is no trap, whatever it is.
const ink = { moveTo() {}, lineTo() {}, bezierCurveTo() {}, closePath() {} };
const drawing = build();
const inContext = codeOf(() => drawing.render({ ...ink, moveTo: () => trapper.a() }));
const afterContext = validate(drawing);

// A trap in a drawing's later portion, after the context has changed the diagram; and one in a
// diagram that the context uses.
const many = new Diagram(randomCircles(5000, 53, 5));
let inserted = false;
const inPortion = codeOf(() =>
  many.renderSites({
    ...ink,
    moveTo() {
      if (inserted) return;
      inserted = true;
      many.insert(0, 0, 1);
      [seen, trapAt, trap] = [0, 1, traps.unreachable];
    },
  }),
);
trapAt = 0;
const other = build();
const inNested = codeOf(() =>
  drawing.renderSites({
    ...ink,
    moveTo() {
      [seen, trapAt] = [0, 1];
      codeOf(() => other.find(0, 0));
      trapAt = 0;
    },
  }),
);
const nested = {
  inPortion,
  next: codeOf(() => many.size),
  inNested,
  inner: codeOf(() => other.size),
  outer: validate(drawing),
  harm: harm(),
};

// The console may throw in the middle of a call.
const print = console.error;
console.error = () => {
  throw new Error("console");
};
const reporting = build();
[seen, trapAt, trap] = [0, 1, () => started.at(-1).env.emscripten_console_error(8)];
const reported = codeOf(() => reporting.find(0, 0));
trapAt = 0;
console.error = print;
const afterReport = harm();

// A view of a diagram of an instance that others have left: its region is of that instance, too.
const pentagon = [
  [-900, -900],
  [900, -900],
  [900, 900],
  [0, 1200],
  [-900, 900],
];
const ofOldInstance = codeOf(() => bystander.voronoi(pentagon).naturalWeights(700, 700));

// Many traps, large diagrams: leaks do not add up.
const failures = new Set();
const rounds = isThorough ? 150 : 30;
for (let k = 0; k < rounds; ++k) {
  const diagram = new Diagram(large);
  [seen, trapAt, trap] = [0, 1, traps.unreachable];
  codeOf(() => diagram.find(0, 0));
  trapAt = 0;
  failures.add(codeOf(() => diagram.size)).add(harm());
}

console.log(
  JSON.stringify({
    perCall,
    inGrowth,
    inContext,
    afterContext,
    nested,
    reported,
    afterReport,
    ofOldInstance,
    failures: [...failures],
  }),
);
