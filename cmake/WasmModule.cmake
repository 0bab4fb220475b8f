# wasm/bindings/ and the library as a wasm module: in the build folder apollonius.mjs, which is
# Emscripten's JavaScript, apollonius.wasm, and apollonius.d.mts, which Embind writes and the
# package's TypeScript compiles against. Not part of `all`.
#
# The library is the very one that the tests link, at the same level.
set(bindings "${CMAKE_CURRENT_SOURCE_DIR}/wasm/bindings")
add_executable(apollonius_wasm EXCLUDE_FROM_ALL "${bindings}/core.cpp" "${bindings}/shapes.cpp"
  "${bindings}/sphere.cpp")
target_link_libraries(apollonius_wasm PRIVATE apollonius apollonius_flags)
set_target_properties(apollonius_wasm PROPERTIES OUTPUT_NAME apollonius SUFFIX .mjs)
target_link_options(apollonius_wasm PRIVATE
  # -O3 and -Os shorten names, among which tests/wasm/support/trapping.mjs finds its way.
  # Two equal functions stay each in its part (tools/toolchain/split_wasm.mjs).
  -lembind -O2 -sBINARYEN_EXTRA_PASSES=-O3,--converge,--skip-pass=duplicate-function-elimination
  -sEMBIND_AOT -sDYNAMIC_EXECUTION=0   # no code made from strings, which a strict policy forbids
  --emit-tsd=apollonius.d.mts
  -sMODULARIZE -sEXPORT_ES6
  -sWASM_ASYNC_COMPILATION=0           # the first diagram starts the module
  # The module uses nothing of its environment and is given its wasm: so it serves pages, workers,
  # Node and edge runtimes.
  -sENVIRONMENT=web -sUSE_ES6_IMPORT_META=0 -sINCOMING_MODULE_JS_API=instantiateWasm -sSTRICT
  --no-entry                           # a library: no `main`
  # Puts the stack back after a call that ended in its middle: wasm/package/core/native/module.ts.
  "SHELL:-sEXPORTED_FUNCTIONS=_emscripten_stack_get_current,__emscripten_stack_restore,\
_expectRoom,_registerCore,_registerShapes,_registerSphere"
  "SHELL:--js-library ${bindings}/embind_parts.js"
  # Names as in the object files, for tools/toolchain/split_wasm.mjs, which drops them.
  --profiling-funcs $<$<NOT:$<CONFIG:Debug>>:-Wl,--no-demangle>
  # 6 KB smaller than the default and as fast here: a diagram is a few large arrays.
  -sMALLOC=emmalloc
  -Wl,--growable-table)                # that of `core` has more elements than the whole module's
set_property(TARGET apollonius_wasm APPEND PROPERTY
  LINK_DEPENDS "${bindings}/embind_parts.js")
if(CMAKE_BUILD_TYPE STREQUAL "Debug")
  # `npm run build -- --debug`
  # Emscripten's own assertions know only the environment that it is told of above.
  target_link_options(apollonius_wasm PRIVATE -O0 -g -gsource-map -sASSERTIONS=0)
endif()
