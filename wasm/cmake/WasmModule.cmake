# wasm/bindings.cpp and the library as one wasm module with its JavaScript glue: apollonius.wasm and apollonius.mjs in the
# build folder, with the glue's types as apollonius.d.mts (for which emcc needs `tsc` on PATH; wasm/build.mjs sees to it). Not part of
# `all`: the tests do not need it. Compiled from the sources once more, because only here link-time optimisation pays (the tests link faster without).
#
# Every visitor of a page downloads this, so only what insertions, deletions, searches and listings run through is compiled for speed. -O3 for everything
# is no faster (measured) and 30 % larger when compressed.
set(quick  # precise_circle.cpp comes first: the linker takes the first copy of each inline function, here those of long numbers
  predicate/precise_circle.cpp
  diagram/conflict.cpp diagram/locate.cpp diagram/insert.cpp diagram/delaunay_graph.cpp
  predicate/voronoi_circle.cpp predicate/edge_circle_filter.cpp graph/graph.cpp
  diagram/diagram_core.cpp diagram/hierarchy.cpp diagram/remove.cpp diagram/spatial_order.cpp diagram/start_grid.cpp
  diagram/site_moves.cpp diagram/ears.cpp predicate/circle_fan.cpp predicate/stages.cpp
  predicate/face_pair.cpp graph/snapshot.cpp diagram/snapshot.cpp
  geometry/render.cpp geometry/clip.cpp geometry/edge.cpp geometry/bisector.cpp geometry/conic.cpp geometry/approximate.cpp
  geometry/border.cpp geometry/areas.cpp geometry/measures.cpp)
list(TRANSFORM quick PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/src/")
set(small ${APOLLONIUS_SOURCES})
list(FILTER small INCLUDE REGEX "/(check|voronoi)\\.cpp$|/src/geometry/")
list(REMOVE_ITEM small ${quick})
set(compact ${APOLLONIUS_SOURCES})
list(REMOVE_ITEM compact ${quick} ${small})
# The doors must not be among the quick: everything that is called in one place only would be copied into them.
list(APPEND compact "${CMAKE_CURRENT_SOURCE_DIR}/wasm/bindings.cpp")
list(APPEND small "${CMAKE_CURRENT_SOURCE_DIR}/wasm/embind_types.cpp")

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
  $<TARGET_OBJECTS:apollonius_wasm_quick> $<TARGET_OBJECTS:apollonius_wasm_compact> $<TARGET_OBJECTS:apollonius_wasm_small>)
target_link_libraries(apollonius_wasm PRIVATE embind)
set_target_properties(apollonius_wasm PROPERTIES OUTPUT_NAME apollonius SUFFIX .mjs LINKER_LANGUAGE CXX)
target_link_options(apollonius_wasm PRIVATE
  -O3 -flto
  -sMODULARIZE=1 -sEXPORT_ES6=1 -sEXPORT_NAME=createApollonius
  -sENVIRONMENT=web,worker         # with "node" the glue imports Node's modules, which bundlers refuse; Node is handed the bytes
  -sWASM_ASYNC_COMPILATION=0       # `new Diagram()` works at once: compiled at the first use, synchronously
  -sDYNAMIC_EXECUTION=0            # no eval: runs under a strict content security policy
  -sFILESYSTEM=0 -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=4GB -sMEMORY_GROWTH_GEOMETRIC_CAP=4194304 -sSTACK_SIZE=1MB
  -sMALLOC=emmalloc                # 6 KB smaller than the default and as fast here: a diagram is a few large arrays
  -sINCOMING_MODULE_JS_API=instantiateWasm
  -sEXPORTED_RUNTIME_METHODS=HEAPU8,HEAP32,HEAPU32,HEAPF64
  --emit-tsd=apollonius.d.mts)
