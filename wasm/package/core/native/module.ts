// The instance of the wasm module that diagrams share: made at the first use, never at import.
// After a call that was cut off, later diagrams get a new instance.
//
// The module comes in parts (tools/toolchain/split_wasm.mjs). `core` is an instance by itself. Each
// of the others is compiled, started in the memory and the table of `core`, and registered with
// Embind when one of its calls is first made.
import createModule, {
  type Builder,
  type Diagram,
  type Fitting,
  type MainModule,
  type NearestFirst,
  type PredicateCounts,
  type Reach,
  type Region,
  type SphericalDiagram,
  type SphericalNearestFirst,
} from "../../../../build/wasm/apollonius.mjs";
import { ApolloniusError } from "../../errors.js";
import { outOfMemory } from "../arguments.js";
import { failure } from "./native_errors.js";

/** A diagram in the module: wasm/bindings/core.cpp. Its calls throw an ApolloniusError. */
export type NativeDiagram = Diagram;
/** A window of any shape in the module, for the diagrams of the same instance. */
export type NativeRegion = Region;
/** A limit in the module of how far cells reach from their circles. */
export type NativeReach = Reach;
/** A diagram of the sphere: wasm/bindings/sphere.cpp. */
export type NativeSphericalDiagram = SphericalDiagram;
export type AnyNative = NativeDiagram | NativeSphericalDiagram;
export type { Builder, Fitting, NearestFirst, SphericalNearestFirst };

/** The functions of a diagram that a part registers, with the types that they have as methods. */
type MethodsOfDiagram = {
  [Name in keyof MainModule as MainModule[Name] extends (...list: infer List) => unknown
    ? List extends [Diagram, ...unknown[]]
      ? Name
      : never
    : never]: MainModule[Name] extends (diagram: Diagram, ...rest: infer Rest) => infer Result
    ? (...rest: Rest) => Result
    : never;
};
/** A diagram with the calls of the part `shapes`: wasm/bindings/shapes.cpp. */
export type NativeShapes = Diagram & MethodsOfDiagram & Pick<MainModule, "Drawing">;

// --- Where the parts come from -------------------------------------------------------------------

export type Part = "core" | "shapes" | "sphere";
/** Gives a compiled part synchronously, or throws if that cannot be. */
type PartSource = () => WebAssembly.Module;

const sources: Partial<Record<Part, PartSource>> = {};

/** Sets the source from which the first use gets a part. The last one set counts. */
export function setSource(part: Part, source: PartSource): void {
  sources[part] = source;
}

/** Returns a compiled part. Throws "not-loaded" if there is none. */
function compiledPart(part: Part): WebAssembly.Module {
  const source = sources[part];
  expectStack();
  if (source !== undefined) return source();
  throw notLoaded(
    `apollonius-diagram/wasm: \`await load({ ${part}: … })\` before the first ` +
      (part === "core" ? "diagram" : `call of ${part}`),
  );
}

// --- The instance --------------------------------------------------------------------------------

interface NativeModule {
  create(): NativeDiagram;
  createSpherical(radius: number): NativeSphericalDiagram;
  predicateCounts(): PredicateCounts;
}

let instance: NativeModule | undefined;

/** Returns the running module; compiles and starts it if this is the first use. */
export function runningModule(): NativeModule {
  return instance ?? start(compiledPart("core"));
}

export function isRunning(): boolean {
  return instance !== undefined;
}

/** Starts a compiled `core` unless one runs already. */
export function start(compiled: WebAssembly.Module): NativeModule {
  return (instance ??= started(compiled));
}

/** The name of a method that starts the part `shapes` in the instance of a diagram's class. */
const kStartShapes = /* @__PURE__ */ Symbol("shapes");

/** Returns the diagram; starts `shapes` in its instance of the module if it is not started. */
export function shapesOf(native: NativeDiagram): NativeShapes {
  (native as unknown as { [kStartShapes](): void })[kStartShapes]();
  return native as NativeShapes;
}

function started(compiled: WebAssembly.Module): NativeModule {
  const { exports, startPart } = instantiated(compiled);
  const { Diagram } = exports;
  const guarded = guard(exports, () => {
    try {
      if (instance === module) instance = started(compiled);
    } catch {} // no memory for a new instance: keep this one
  });
  const guardMethods = ({ prototype: methods }: Class, known: readonly string[] = []) => {
    for (const name of Object.getOwnPropertyNames(methods))
      if (name !== "constructor" && !known.includes(name))
        methods[name] = guarded(methods[name] as Method);
  };
  const guardClass = (added: Class) => {
    guardMethods(added);
    const { prototype: methods } = added;
    const { delete: free, isDeleted } = methods; // inherited; each call asks isDeleted()
    Object.assign(methods, { delete: guarded(free as Method, true), isDeleted });
  };

  /** Has Embind register the calls of a part, if there is room for all of them. */
  const register = (calls: () => void) => {
    const registering = guarded(() => {
      exports._expectRoom();
      calls();
    });
    registering.call(nobody);
  };
  const once = (begin: () => void) => {
    let hasBegun = false;
    return () => {
      if (hasBegun) return;
      begin();
      hasBegun = true;
    };
  };

  // A first insertion and query take few calls; a look-up of any other call registers the rest of
  // core. Until then, Embind's handles inherit from `unregistered`.
  const methods = Diagram.prototype as Record<PropertyKey, unknown>;
  const inherited = Object.getPrototypeOf(methods) as object;
  const unregistered = new Proxy(inherited, {
    get(_, name, diagram) {
      startCore();
      return diagram[name];
    },
  });
  guardClass(Diagram);
  const first = Object.getOwnPropertyNames(methods);
  Object.setPrototypeOf(methods, unregistered);
  const startCore = once(() => {
    expectStack();
    Object.setPrototypeOf(methods, inherited); // Embind looks for what it registers
    try {
      register(exports._registerCore);
    } catch (error) {
      Object.setPrototypeOf(methods, unregistered);
      throw error;
    }
    guardMethods(Diagram, first);
    guardClass(exports.Builder);
    guardClass(exports.NearestFirst);
  });

  methods[kStartShapes] = once(() => {
    startCore();
    const ofCore = new Set(Object.keys(exports));
    startPart("shapes");
    register(exports._registerShapes);
    for (const added of [exports.Region, exports.Reach, exports.Fitting]) guardClass(added);
    methods.Drawing = exports.Drawing;
    // Only the calls: names that begin with a capital are classes and enumerations.
    for (const name of Object.keys(exports).filter(
      (key) => !ofCore.has(key) && /^[a-z]/.test(key),
    )) {
      const call = exports[name as keyof Exports] as Method;
      methods[name] = guarded(function (this: Handle, a, b, c, d, e, f, g, h, i, j) {
        return call(this as never, a, b, c, d, e, f, g, h, i, j);
      });
    }
  });
  const startSphere = once(() => {
    startCore();
    startPart("sphere");
    register(exports._registerSphere);
    guardClass(exports.SphericalDiagram);
    guardClass(exports.SphericalBuilder);
    guardClass(exports.SphericalNearestFirst);
  });

  const create = guarded(() => new Diagram());
  const createSpherical = guarded((radius: number) => new exports.SphericalDiagram(radius));
  const module: NativeModule = {
    create: () => create.call(nobody) as NativeDiagram,
    createSpherical(radius) {
      startSphere();
      return createSpherical.call(nobody, radius as never) as NativeSphericalDiagram;
    },
    predicateCounts() {
      startCore();
      return guarded(exports.predicateCounts).call(nobody) as PredicateCounts;
    },
  };
  return module;
}

type Class = { prototype: Record<string, Method> };
type Exports = MainModule &
  Record<
    | "Diagram"
    | "Builder"
    | "Fitting"
    | "NearestFirst"
    | "Reach"
    | "Region"
    | "SphericalBuilder"
    | "SphericalDiagram"
    | "SphericalNearestFirst",
    Class
  >;

/**
 * Throws a RangeError if little of the stack is left. If the stack ends within Emscripten's own
 * start, or within Embind's registrations, these are left half done: a promise that nobody sees is
 * rejected, or V8 ends the process as it compiles a regular expression. After this check, a
 * RangeError means a lack of memory.
 */
function expectStack(frames = 1000): void {
  if (frames > 0) expectStack(frames - 1);
}

/** Returns a new instance; throws "out-of-memory" if there is no room for it. */
function instanceOf(
  compiled: WebAssembly.Module,
  imports: WebAssembly.Imports,
): WebAssembly.Instance {
  try {
    return new WebAssembly.Instance(compiled, imports);
  } catch (cause) {
    throw cause instanceof RangeError ? outOfMemory() : cause;
  }
}

/** Returns the exports of an instance of `core`, to which `startPart` adds those of a part. */
function instantiated(compiled: WebAssembly.Module): {
  exports: Exports;
  startPart(part: Part): void;
} {
  expectStack();
  let failed: { cause: unknown } | undefined;
  let core: WebAssembly.Exports = {};
  type Receive = (instance: WebAssembly.Instance) => object;
  const exports = createModule({
    instantiateWasm(imports: WebAssembly.Imports, receive: Receive): object {
      try {
        const started = instanceOf(compiled, imports);
        core = started.exports;
        return receive(started);
      } catch (cause) {
        failed = { cause }; // Emscripten would turn it into a promise that nobody sees
        return {};
      }
    },
  });
  if (failed) throw failed.cause;
  return {
    exports: exports as Exports,
    startPart: (part) => void instanceOf(compiledPart(part), { core }),
  };
}

type Argument = never; // any type
type Method = (...list: Argument[]) => unknown;
interface Handle {
  isDeleted(): boolean;
}
/** Stands for the diagram in calls that have none. */
const nobody: Handle = { isDeleted: () => false };

/**
 * Guards calls against being cut off: by a trap, which is a defect of the library, or by an
 * exhausted stack, which nothing foresees. The diagram of such a call may be half changed. From
 * then on it is broken: every call of it throws, and its memory is never given back, as its
 * destructor might follow a wrong address. For all other diagrams, the module's stack pointer is
 * restored; also after a call that threw an error's number, which does not restore it itself.
 */
function guard(
  native: Pick<
    MainModule,
    "Error" | "_emscripten_stack_get_current" | "__emscripten_stack_restore"
  >,
  retire: () => void,
): (plain: Method, isDelete?: boolean) => Method {
  const top = native._emscripten_stack_get_current();
  const broken = new WeakSet<Handle>();
  let isAnyBroken = false;
  let running: Handle | undefined; // the diagram of the call under way

  /**
   * Marks the diagram as broken and restores the stack after a call that was cut off. At the end of
   * the stack this may fail itself; then the next call does it.
   */
  const settle = (diagram: Handle) => {
    running = diagram;
    if (diagram !== nobody) broken.add(diagram);
    isAnyBroken = true;
    native.__emscripten_stack_restore(top);
    retire();
    running = undefined;
  };
  const ended = (cause?: unknown) =>
    new ApolloniusError(
      "broken",
      "a call of this diagram was cut off: please report it, unless the stack overflowed",
      { cause },
    );

  return (plain, isDelete = false) =>
    // As many parameters as any call has: rest parameters would make a new array for each call.
    function (
      this: Handle,
      a: Argument,
      b: Argument,
      c: Argument,
      d: Argument,
      e: Argument,
      f: Argument,
      g: Argument,
      h: Argument,
      i: Argument,
      j: Argument,
    ): unknown {
      if (running !== undefined) settle(running);
      if (isAnyBroken && broken.has(this)) {
        if (isDelete) return;
        throw ended();
      }
      if (this.isDeleted())
        // by the caller's code, which runs while arguments are read and while contexts draw
        throw new ApolloniusError("disposed", "the diagram was disposed of during the call");
      running = this;
      let error: unknown;
      try {
        const result = plain.call(this, a, b, c, d, e, f, g, h, i, j);
        running = undefined;
        return result;
      } catch (thrown) {
        error = thrown;
      }
      const isException = isCppException(error);
      if (typeof error !== "number" && !isException) {
        settle(this);
        throw ended(error);
      }
      native.__emscripten_stack_restore(top);
      running = undefined;
      throw isException ? outOfMemory() : failure(native.Error, error as number);
    };
}

/** Is it an uncaught C++ exception? It means a lack of memory where Embind itself needs bytes. */
function isCppException(error: unknown): boolean {
  const { Exception } = WebAssembly as unknown as { Exception?: new () => unknown };
  return Exception !== undefined && error instanceof Exception;
}

// --- The errors of a module that cannot be loaded ------------------------------------------------

export function notLoaded(message: string, cause?: unknown): ApolloniusError {
  return new ApolloniusError("not-loaded", message, { cause });
}

/** Turns an engine's error, when it cannot compile or start a module, into an ApolloniusError. */
export function notCompiled(cause: unknown): unknown {
  if (cause instanceof ApolloniusError) return cause;
  if (cause instanceof RangeError) return outOfMemory();
  const why = cause instanceof Error ? cause.message : String(cause);
  return notLoaded(
    `WebAssembly cannot be compiled here (${why}). A content security policy has to have ` +
      "script-src 'wasm-unsafe-eval'; where nothing may be compiled, give load() of " +
      "apollonius-diagram/wasm the module that importing the .wasm gives",
    cause,
  );
}
