# wasm/bindings.cpp and the library as one wasm module, apollonius.wasm in the build folder. Not
# part of `all`: the tests do not need it. Compiled from the sources once more, because only here
# link-time optimisation pays (the tests link faster without).
#
# No JavaScript comes with it: wasm/module.ts starts it in twenty lines, where Emscripten's were
# more than a third of all JavaScript in the package. What it imports is in wasm/bindings.cpp.
#
# Every visitor of a page downloads this, so all is compiled for size but what insertions, searches
# and drawings of many sites run through (bench/README.md, "Size", has what each step costs and
# gives).
set(quick
  predicate/circle_fan.cpp predicate/edge_circle_filter.cpp number/fixed_integer.cpp
  delaunay/conflict.cpp delaunay/locate.cpp delaunay/sort_by_key.cpp
  geometry/render.cpp geometry/clip.cpp geometry/edge.cpp predicate/stages.cpp)
set(compact
  predicate/voronoi_circle.cpp delaunay/moves.cpp delaunay/insert.cpp
  predicate/predicates.cpp geometry/bisector.cpp geometry/approximate.cpp)
list(TRANSFORM quick PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/src/")
list(TRANSFORM compact PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/src/")
set(small ${APOLLONIUS_SOURCES})
list(REMOVE_ITEM small ${quick} ${compact} "${CMAKE_CURRENT_SOURCE_DIR}/src/number/invariant.cpp")
# The bindings must not be among the quick: everything that is called in one place only would be
# copied into them.
list(APPEND small
  "${CMAKE_CURRENT_SOURCE_DIR}/wasm/bindings.cpp"
  "${CMAKE_CURRENT_SOURCE_DIR}/wasm/lean_runtime.cpp")

foreach(part_and_level IN ITEMS quick:-O2 compact:-Os small:-Oz)
  string(REPLACE ":" ";" part_and_level ${part_and_level})
  list(GET part_and_level 0 part)
  list(GET part_and_level 1 level)
  add_library(apollonius_wasm_${part} OBJECT EXCLUDE_FROM_ALL ${${part}})
  target_include_directories(apollonius_wasm_${part} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/src")
  target_link_libraries(apollonius_wasm_${part} PRIVATE apollonius_flags)
  target_compile_options(apollonius_wasm_${part} PRIVATE -flto ${level})
  target_compile_definitions(apollonius_wasm_${part} PRIVATE APOLLONIUS_FLAT_ARRAYS)
endforeach()

add_executable(apollonius_wasm EXCLUDE_FROM_ALL
  # The quick ones first: the linker takes the first copy of each inline function.
  $<TARGET_OBJECTS:apollonius_wasm_quick> $<TARGET_OBJECTS:apollonius_wasm_small>
  $<TARGET_OBJECTS:apollonius_wasm_compact>)
set_target_properties(apollonius_wasm PROPERTIES
  OUTPUT_NAME apollonius SUFFIX .wasm LINKER_LANGUAGE CXX)
target_link_options(apollonius_wasm PRIVATE
  -O3 -flto  # of what the linker optimises: -Oz saves 0.5 KB and draws a quarter more slowly
  # Copies across files only of what is called in one place, or is smaller than a call: 1.6 KB less,
  # and as fast. Few loops gain by vectors that do not have them already (number/pair.h).
  -Wl,-mllvm,-inline-threshold=-50 -Wl,-mllvm,-vectorize-loops=false
  --no-entry                       # a library: `_initialize` instead of `main`
  -Wl,--wrap=emscripten_resize_heap
  -Wl,--export=__stack_pointer     # wasm/module.ts puts it back after a trap
  -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=4GB -sSTACK_SIZE=1MB
  # 6 KB smaller than the default and as fast here: a diagram is a few large arrays.
  -sMALLOC=emmalloc)
if(CMAKE_BUILD_TYPE STREQUAL "Debug")
  # `npm run build -- --debug`
  target_link_options(apollonius_wasm PRIVATE -O0 -g -gsource-map)
endif()
