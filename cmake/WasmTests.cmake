# The tests that also run as WebAssembly in every `npm test`: those whose answer may differ there.
# Tests that compute (other instructions for the same doubles, vectors of two), that need memory
# (32-bit sizes, another allocator), that count without the shadow check of the native build, and
# that compare recorded hashes. Histories of the diagram run in Jest on the module that is shipped.
# `npm run check -- wasm` runs all.
set(wasm_tests
  # Numbers and predicates
  number/approx number/ball number/dyadic number/fixed_integer number/fp number/root_sign
  number/twofold
  predicate/circle_fan predicate/near_zero predicate/precise_circle predicate/scale
  predicate/stage_use predicate/vertex_conflict
  # Memory
  base/flat_array diagram/out_of_memory geometry/out_of_memory topology/room
  # Counted work, and snapshots that the shadow check would stop
  delaunay/unproved_graph diagram/snapshot_mutants diagram/work_in_line diagram/work_of_batches
  diagram/worst_orders
  # Recorded hashes
  diagram/determinism geometry/voronoi sphere/out_of_memory)
set(all_files "${test_files}")
set(test_files "")
foreach(name IN LISTS wasm_tests)
  set(file "${tests}/${name}_test.cpp")
  if(NOT file IN_LIST all_files)
    message(FATAL_ERROR "cmake/WasmTests.cmake names ${name}, but there is no ${file}")
  endif()
  list(APPEND test_files "${file}")
endforeach()
