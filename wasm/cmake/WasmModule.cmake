# wasm/bindings.cpp and the library as one wasm module with its JavaScript glue: apollonius.wasm and apollonius.mjs in the
# build folder, with the glue's types as apollonius.d.mts (for which emcc needs `tsc` on PATH; wasm/build.mjs sees to it). Not part of
# `all`: the tests do not need it. Compiled from the sources once more, because only here link-time optimisation pays (the tests link faster without).
add_executable(apollonius_wasm EXCLUDE_FROM_ALL "${CMAKE_CURRENT_SOURCE_DIR}/wasm/bindings.cpp" ${APOLLONIUS_SOURCES})
target_include_directories(apollonius_wasm PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/src")
target_link_libraries(apollonius_wasm PRIVATE apollonius_flags embind)
target_compile_options(apollonius_wasm PRIVATE -flto)
set_target_properties(apollonius_wasm PROPERTIES OUTPUT_NAME apollonius SUFFIX .mjs)
target_link_options(apollonius_wasm PRIVATE
  -O3 -flto
  -sMODULARIZE=1 -sEXPORT_ES6=1 -sEXPORT_NAME=createApollonius
  -sENVIRONMENT=web,worker         # with "node" the glue imports Node's modules, which bundlers refuse; Node is handed the bytes
  -sWASM_ASYNC_COMPILATION=0       # `new Diagram()` works at once: compiled at the first use, synchronously
  -sDYNAMIC_EXECUTION=0            # no eval: runs under a strict content security policy
  -sFILESYSTEM=0 -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=4GB -sMEMORY_GROWTH_GEOMETRIC_CAP=4194304 -sSTACK_SIZE=1MB
  -sINCOMING_MODULE_JS_API=instantiateWasm
  -sEXPORTED_RUNTIME_METHODS=HEAPU8,HEAP32,HEAPU32,HEAPF64
  --emit-tsd=apollonius.d.mts)
