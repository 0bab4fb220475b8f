// The instance of the wasm module that diagrams share: made at the first use, never at import.
// After a call that ended in its middle, what is made later gets a new one.
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
} from "../../../build/wasm/apollonius.mjs";
import { outOfMemory } from "../arguments.js";
import { ApolloniusError } from "../errors.js";
import { failure } from "./native_errors.js";

/** A diagram in the module: wasm/bindings/bindings.cpp. Its calls throw an ApolloniusError. */
export type NativeDiagram = Diagram;
/** A window of any shape there, for the diagrams of the same instance. */
export type NativeRegion = Region;
/** How far cells reach there. */
export type NativeReach = Reach;
/** A diagram of the sphere: wasm/bindings/spherical_adapters.h. */
export type NativeSphericalDiagram = SphericalDiagram;
export type { Builder, Fitting, NearestFirst, SphericalNearestFirst };

interface NativeModule {
  create(location: keyof MainModule["Location"]): NativeDiagram;
  createSpherical(radius: number): NativeSphericalDiagram;
  predicateCounts(): PredicateCounts;
  readonly Drawing: MainModule["Drawing"];
  readonly Source: MainModule["Source"];
  readonly Top: MainModule["Top"];
}

/** Gives the compiled module synchronously, or throws if that entry of the package cannot. */
type ModuleSource = () => WebAssembly.Module;

let source: ModuleSource | undefined;
let instance: NativeModule | undefined;

/**
 * Tells where the first use gets the compiled module from. Each entry of the package calls this
 * once.
 */
export function setModuleSource(moduleSource: ModuleSource): void {
  source = moduleSource;
}

let sphereSource: ModuleSource | undefined;

/** Tells where an instance gets its second part from, when that is first called. */
export function setSphereSource(moduleSource: ModuleSource): void {
  sphereSource = moduleSource;
}

/**
 * Where `apollonius-diagram/sphere` finds the functions above and below: a property of the class
 * Diagram.
 */
export const kModule: unique symbol = /* @__PURE__ */ Symbol.for("apollonius-diagram.module");

/** The running module; compiled and started now if this is the first use. */
export function runningModule(): NativeModule {
  return instance ?? start((source as ModuleSource)());
}

export function isRunning(): boolean {
  return instance !== undefined;
}

/** Starts a compiled module unless one runs already. */
export function start(compiled: WebAssembly.Module): NativeModule {
  return (instance ??= started(compiled));
}

function started(compiled: WebAssembly.Module): NativeModule {
  const { Diagram, Builder, Fitting, NearestFirst, Reach, Region, ...others } =
    instantiated(compiled);
  const { SphericalDiagram, SphericalNearestFirst, ...rest } = others;
  const { Location, Drawing, Source, Top } = rest;
  const guarded = guard(rest, () => {
    try {
      if (instance === module) instance = started(compiled);
    } catch {} // no memory for another: this one goes on
  });
  const classes = [
    Diagram,
    Builder,
    Fitting,
    NearestFirst,
    Reach,
    Region,
    SphericalDiagram,
    SphericalNearestFirst,
  ];
  for (const { prototype: methods } of classes) {
    for (const name of [...Object.getOwnPropertyNames(methods), "delete"])
      if (name !== "constructor")
        methods[name] = guarded(methods[name] as Method, name === "delete");
  }
  const predicateCounts = guarded(rest.predicateCounts);
  const create = guarded((location: keyof typeof Location) => new Diagram(Location[location]));
  const createSpherical = guarded((radius: number) => new SphericalDiagram(radius));
  const module: NativeModule = {
    create: (location) => create.call(nobody, location as never) as NativeDiagram,
    createSpherical: (radius) =>
      createSpherical.call(nobody, radius as never) as NativeSphericalDiagram,
    predicateCounts: () => predicateCounts.call(nobody) as PredicateCounts,
    Drawing,
    Source,
    Top,
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
    | "SphericalDiagram"
    | "SphericalNearestFirst",
    Class
  >;

/**
 * Throws a RangeError if little of the stack is left. Where it ends within Emscripten's own start,
 * a promise that nobody sees is rejected, or V8 ends the process as it compiles a regular
 * expression.
 */
function expectStack(frames = 1000): void {
  if (frames > 0) expectStack(frames - 1);
}

/** The first part of an instance, and whether the second is there. */
interface FirstPart {
  exports: WebAssembly.Exports;
  isWhole: boolean;
}

/**
 * Stands for a function of the second part (tools/toolchain/split_wasm.mjs) until that is there: it
 * puts its functions into the table of the first.
 */
function placeholder(first: FirstPart, index: number): Method {
  let method: Method | undefined;
  return (...list) => {
    if (!first.isWhole) {
      new WebAssembly.Instance((sphereSource as ModuleSource)(), { first: first.exports });
      first.isWhole = true;
    }
    const table = first.exports.__indirect_function_table as WebAssembly.Table;
    return (method ??= table.get(index) as Method)(...list);
  };
}

function instantiated(compiled: WebAssembly.Module): Exports {
  expectStack();
  let failed: { cause: unknown } | undefined;
  const first: FirstPart = { exports: {}, isWhole: false };
  type Receive = (instance: WebAssembly.Instance) => object;
  const exports = createModule({
    instantiateWasm(imports: WebAssembly.Imports, receive: Receive): object {
      try {
        const later = new Proxy({}, { get: (_, index) => placeholder(first, Number(index)) });
        const instance = new WebAssembly.Instance(compiled, { ...imports, later });
        first.exports = instance.exports;
        return receive(instance);
      } catch (cause) {
        // Emscripten would turn it into a promise that nobody sees. No stack is lacking here.
        failed = { cause: cause instanceof RangeError ? outOfMemory() : cause };
        return {};
      }
    },
  });
  if (failed) throw failed.cause;
  return exports as Exports;
}

type Argument = never; // of whatever type
type Method = (...list: Argument[]) => unknown;
interface Handle {
  isDeleted(): boolean;
}
/** Stands for the diagram in calls that have none. */
const nobody: Handle = { isDeleted: () => false };

/**
 * Guards calls against what ends one in its middle: a trap, which is a defect of the library, or an
 * exhausted stack, which nothing foresees. The diagram of that call may be half changed: from then
 * on it is broken, every call of it throws, and its memory is never given back, as its destructor
 * might follow a wrong address. All others find the module's stack as it has to be; so they do
 * after a call that threw an error's number, which leaves the stack where it was, too.
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
   * Sets things right after a call that ended in its middle. At the end of the stack this may fail
   * itself: then the next call does it.
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
      "a call of this diagram ended in its middle: please report it, unless no stack was left",
      { cause },
    );

  return (plain, isDelete = false) =>
    // As many parameters as any has: a list of the rest would be made anew for each call.
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

/** A C++ exception that nobody caught: a lack of memory where Embind itself needs some bytes. */
function isCppException(error: unknown): boolean {
  const { Exception } = WebAssembly as unknown as { Exception?: new () => unknown };
  return Exception !== undefined && error instanceof Exception;
}

// --- The errors of a module that cannot be loaded ------------------------------------------------

export function notLoaded(message: string, cause?: unknown): ApolloniusError {
  return new ApolloniusError("not-loaded", message, { cause });
}

/** What an engine says when it does not compile or start a module. */
export function notCompiled(cause: unknown): unknown {
  if (cause instanceof RangeError) return cause; // the end of the stack
  const why = cause instanceof Error ? cause.message : String(cause);
  return notLoaded(
    `WebAssembly cannot be compiled here (${why}). A content security policy has to have ` +
      "script-src 'wasm-unsafe-eval'; where nothing may be compiled, as on some servers at the " +
      "edge, import the .wasm and give that module to load() of apollonius-diagram/wasm",
    cause,
  );
}
