# wasm/bindings.cpp and the library as one wasm module with its JavaScript glue: apollonius.wasm and apollonius.mjs in the
# build folder. Compiled from the sources once more, because only here link-time optimisation pays (the tests link faster without).
add_executable(apollonius_wasm "${CMAKE_CURRENT_SOURCE_DIR}/wasm/bindings.cpp" ${APOLLONIUS_SOURCES})
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
  -sFILESYSTEM=0 -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=4GB -sSTACK_SIZE=256KB
  -sINCOMING_MODULE_JS_API=wasmBinary,instantiateWasm
  -sASSERTIONS=0)
