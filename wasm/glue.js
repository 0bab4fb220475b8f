// What the wasm module asks of JavaScript beyond Emscripten's own glue: a JS library, which replaces functions of the same name.
addToLibrary({
  reportBrokenInvariant__deps: ['$AsciiToString'],
  reportBrokenInvariant: (name) => err(`apollonius: broken invariant: ${AsciiToString(name)}`),
});

// Embind's JavaScript, reduced to what wasm/bindings.cpp registers: functions of numbers. Emscripten's own checks and converts arguments
// of any type, for which nobody has a use here (native.ts is the only caller, and TypeScript knows the types that emcc writes); it
// would be a third of all JavaScript in the package. Results are plain wasm integers: addresses are `>>> 0` where they are used.
//
// To write the types, emcc runs the program once with embind's generator instead, and without MODULARIZE.
#if MODULARIZE
addToLibrary({
  _embind_register_function__deps: ['$AsciiToString', '$wasmTable'],
  _embind_register_function: (name, argCount, rawArgTypesAddr, signature, rawInvoker, fn, isAsync, isNonnullReturn) => {
    const call = wasmTable.get(rawInvoker);
    Module[AsciiToString(name)] = (...args) => call(fn, ...args);
  },
  _embind_register_void__deps: ['free', '__getTypeName'],  // which the generator calls
  _embind_register_void: (rawType, name) => {},
  _embind_register_bool: (rawType, name, trueValue, falseValue) => {},
  _embind_register_integer: (primitiveType, name, size, minRange, maxRange) => {},
});
#endif
