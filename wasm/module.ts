// The one instance of the wasm module that all diagrams share: made at the first use, never at import.
import createModule, { type MainModule } from "../build/wasm/apollonius.mjs";

/** Gives the compiled module synchronously, or throws if that entry of the package cannot. */
type ModuleSource = () => WebAssembly.Module;

let source: ModuleSource | undefined;
let instance: MainModule | undefined;

/** Tells where the first use gets the compiled module from. Each entry of the package calls this once. */
export function setModuleSource(moduleSource: ModuleSource): void {
  source = moduleSource;
}

/** The running module; compiled and started now if this is the first use. */
export function runningModule(): MainModule {
  return instance ?? start((source as ModuleSource)());
}

export function isRunning(): boolean {
  return instance !== undefined;
}

/** Starts a compiled module unless one runs already. Synchronous: the glue is built with WASM_ASYNC_COMPILATION=0. */
export function start(compiled: WebAssembly.Module): MainModule {
  instance ??= createModule({
    instantiateWasm(imports: WebAssembly.Imports, receive: (instance: WebAssembly.Instance) => unknown) {
      const started = new WebAssembly.Instance(compiled, imports);
      receive(started);
      return started.exports;
    },
  });
  return instance;
}
