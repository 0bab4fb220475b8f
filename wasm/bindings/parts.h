// The parts of the module beside `core`. The build splits the module into files by the folders in
// which functions are defined (tools/toolchain/split_wasm.mjs), so that who never asks for a part
// does not load it.
#pragma once

/// Throws kOutOfMemory unless there is room for all that Embind keeps of a part. JavaScript asks
/// before it has a part registered, which cannot be done again.
extern "C" void expectRoom();

/// Registers the calls of a part with Embind; of `core`, those that are not there from the start.
/// JavaScript calls each once, when the part is there, `core` first.
extern "C" void registerCore();
extern "C" void registerShapes();
extern "C" void registerSphere();

/// Is this run the one in which Embind writes the types (embind_parts.js)? It is to see all parts.
extern "C" bool areTypesWritten();
