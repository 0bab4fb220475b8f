# wasm/bindings.cpp and the library as one wasm module with its JavaScript glue: apollonius.wasm and apollonius.mjs in the
# build folder, with the glue's types as apollonius.d.mts (for which emcc needs `tsc` on PATH; wasm/build.mjs sees to it). Not part of
# `all`: the tests do not need it. Compiled from the sources once more, because only here link-time optimisation pays (the tests link faster without).
#
# Every visitor of a page downloads this, so all is compiled for size but what insertions, searches and drawings of many sites run through
# (bench/README.md, "Size", has what each step costs and gives).
set(quick
  predicate/circle_fan.cpp predicate/edge_circle_filter.cpp number/whole.cpp
  diagram/conflict.cpp diagram/locate.cpp diagram/insert.cpp diagram/sort_by_key.cpp
  predicate/stages.cpp geometry/render.cpp geometry/clip.cpp)
set(compact
  predicate/predicates.cpp predicate/long_stages.cpp predicate/voronoi_circle.cpp
  graph/graph.cpp graph/snapshot.cpp diagram/snapshot.cpp diagram/site_moves.cpp)
list(TRANSFORM quick PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/src/")
list(TRANSFORM compact PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/src/")
set(small ${APOLLONIUS_SOURCES})
list(REMOVE_ITEM small ${quick} ${compact} "${CMAKE_CURRENT_SOURCE_DIR}/src/diagram/invariant.cpp")
# The doors must not be among the quick: everything that is called in one place only would be copied into them.
list(APPEND small "${CMAKE_CURRENT_SOURCE_DIR}/wasm/bindings.cpp" "${CMAKE_CURRENT_SOURCE_DIR}/wasm/embind_types.cpp")

foreach(part_and_level IN ITEMS quick:-O2 compact:-Os small:-Oz)
  string(REPLACE ":" ";" part_and_level ${part_and_level})
  list(GET part_and_level 0 part)
  list(GET part_and_level 1 level)
  add_library(apollonius_wasm_${part} OBJECT EXCLUDE_FROM_ALL ${${part}})
  target_include_directories(apollonius_wasm_${part} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/src")
  target_link_libraries(apollonius_wasm_${part} PRIVATE apollonius_flags)
  target_compile_options(apollonius_wasm_${part} PRIVATE -flto ${level})
endforeach()

add_executable(apollonius_wasm EXCLUDE_FROM_ALL
  # The quick ones first: the linker takes the first copy of each inline function.
  $<TARGET_OBJECTS:apollonius_wasm_quick> $<TARGET_OBJECTS:apollonius_wasm_compact> $<TARGET_OBJECTS:apollonius_wasm_small>)
target_link_libraries(apollonius_wasm PRIVATE embind "--js-library=${CMAKE_CURRENT_SOURCE_DIR}/wasm/glue.js")  # the later one's functions win
set_target_properties(apollonius_wasm PROPERTIES LINK_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/wasm/glue.js" OUTPUT_NAME apollonius SUFFIX .mjs LINKER_LANGUAGE CXX)
target_link_options(apollonius_wasm PRIVATE
  -O3 -flto  # of what the linker optimises: -Oz saves 0.5 KB and draws a quarter more slowly
  -sMODULARIZE=1 -sEXPORT_ES6=1 -sEXPORT_NAME=createApollonius
  -sENVIRONMENT=web,worker         # with "node" the glue imports Node's modules, which bundlers refuse; Node is handed the bytes
  -sWASM_ASYNC_COMPILATION=0       # `new Diagram()` works at once: compiled at the first use, synchronously
  -sDYNAMIC_EXECUTION=0            # no eval: runs under a strict content security policy
  -sFILESYSTEM=0 -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=4GB -sMEMORY_GROWTH_GEOMETRIC_CAP=4194304 -sSTACK_SIZE=1MB
  -sMALLOC=emmalloc                # 6 KB smaller than the default and as fast here: a diagram is a few large arrays
  -sINCOMING_MODULE_JS_API=instantiateWasm
  -sEXPORTED_RUNTIME_METHODS=HEAPU8,HEAP32,HEAPU32,HEAPF64
  --emit-tsd=apollonius.d.mts)
