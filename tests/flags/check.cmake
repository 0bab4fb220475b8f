# Flags that change arithmetic are refused: a CTest script.
#
#   cmake -DROOT=… -DWORK=… -DCXX=… -P check.cmake
#
# Configuring refuses them, in whatever way they come. The sources refuse them where they are
# compiled without our CMake files. Flags that define no macro are noticed when the program runs.
cmake_minimum_required(VERSION 3.25)

function(expect_failure what pattern)
  execute_process(COMMAND ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  string(REGEX REPLACE "[ \n]+" " " text "${output} ${errors}")
  if(result EQUAL 0 OR NOT text MATCHES "${pattern}")
    message(SEND_ERROR "${what}: expected \"${pattern}\", got ${result}: ${text}")
  endif()
endfunction()

function(expect_success what)
  execute_process(COMMAND ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT result EQUAL 0)
    message(SEND_ERROR "${what}: ${result}: ${output} ${errors}")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")

# --- Configuring: the library by itself, and within a consumer's project --------------------------
set(configure "${CMAKE_COMMAND}" -DCMAKE_CXX_COMPILER=${CXX} -DAPOLLONIUS_TESTS=OFF)
set(own ${configure} -S "${ROOT}" -B "${WORK}/own" --fresh)
foreach(flags IN ITEMS -ffast-math -Ofast "-O2 -mfma -ffp-contract=fast"
    -funsafe-math-optimizations -fassociative-math)
  expect_failure("CMAKE_CXX_FLAGS=${flags}" "changes arithmetic"
    ${own} "-DCMAKE_CXX_FLAGS=${flags}")
endforeach()
expect_failure("CMAKE_CXX_FLAGS_RELEASE" "-Ofast changes arithmetic"
  ${own} -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=-Ofast -DNDEBUG")
expect_failure("CXXFLAGS" "-ffast-math changes arithmetic"
  "${CMAKE_COMMAND}" -E env CXXFLAGS=-ffast-math ${own})
expect_failure("a shared library's linker" "-ffast-math changes arithmetic"
  ${own} -DCMAKE_SHARED_LINKER_FLAGS=-ffast-math)
expect_success("flags of the machine" ${own} "-DCMAKE_CXX_FLAGS=-march=native -O3 -g")

file(WRITE "${WORK}/consumer/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)
project(consumer CXX)
add_compile_options(\${OPTIONS})
add_link_options(\${LINK_OPTIONS})
add_subdirectory(${ROOT} apollonius)
")
set(consumer ${configure} -S "${WORK}/consumer" -B "${WORK}/consumer/build" --fresh)
expect_failure("a consumer's options" "-ffast-math changes arithmetic"
  ${consumer} "-DOPTIONS=SHELL:-O2 -ffast-math")
expect_failure("a consumer's link options" "-Ofast changes arithmetic"
  ${consumer} -DLINK_OPTIONS=-Ofast)
expect_success("a consumer" ${consumer} -DOPTIONS=-O2)

# --- Compiled by hand -----------------------------------------------------------------------------
file(WRITE "${WORK}/main.cpp" "#include <cstdio>
#include \"number/fp.h\"
int main() {
  const char* defect = apollonius::internal::arithmeticViolation();
  std::puts(defect == nullptr ? \"as assumed\" : defect);
  return defect != nullptr;
}
")
set(compile "${CXX}" -std=c++20 -O2 -I "${ROOT}/src")
set(sources "${WORK}/main.cpp" "${ROOT}/src/number/fp.cpp" -o "${WORK}/main")
foreach(flag IN ITEMS -ffast-math -Ofast -ffinite-math-only)
  expect_failure("${flag} by hand" "fast-math breaks the error bounds"
    ${compile} ${flag} -fsyntax-only "${ROOT}/src/number/fp.cpp")
endforeach()
expect_success("by hand" ${compile} ${sources})
expect_success("runs" "${WORK}/main")
if(CMAKE_HOST_SYSTEM_PROCESSOR STREQUAL "x86_64" AND EXISTS /proc/cpuinfo)
  file(READ /proc/cpuinfo processor)
  if(processor MATCHES "[ \n]fma[ \n]")
    expect_success("contracted" ${compile} -mfma -ffp-contract=fast ${sources})
    expect_failure("contracted, run" "are contracted" "${WORK}/main")
    expect_success("with the machine's flags" ${compile} -march=native -ffp-contract=off ${sources})
    expect_success("with the machine's flags, run" "${WORK}/main")
  endif()
  expect_success("objects" ${compile} -c "${WORK}/main.cpp" -o "${WORK}/main.o")
  expect_success("objects" ${compile} -c "${ROOT}/src/number/fp.cpp" -o "${WORK}/fp.o")
  expect_success("linked with fast-math"
    "${CXX}" -ffast-math "${WORK}/main.o" "${WORK}/fp.o" -o "${WORK}/main")
  expect_failure("linked with fast-math, run" "flushed to zero" "${WORK}/main")
endif()

# --- The library as it was built ------------------------------------------------------------------
# No instruction rounds once where the bounds count two roundings.
if(OBJDUMP AND LIBRARY)
  set(pattern "vfn?m(add|sub)[a-z]*[0-9]|[[:space:]](fn?m(add|sub)|fml[as])[[:space:]]")
  execute_process(COMMAND "${OBJDUMP}" --disassemble --no-show-raw-insn "${LIBRARY}"
    COMMAND grep -m1 -E "${pattern}" OUTPUT_VARIABLE fused)
  if(fused)
    message(SEND_ERROR "the library has a fused instruction: ${fused}")
  endif()
endif()
