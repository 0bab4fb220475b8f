# GoogleTest executables from tests/: each folder that holds *_test.cpp files becomes one
# executable, `number_tests` for tests/number and so on; files of tests/ itself become `core_tests`.
# All sources are built natively; for wasm those named in WasmTests.cmake, or all with
# -DAPOLLONIUS_ALL_WASM_TESTS=ON (`npm run check -- wasm`).
#
# Natively CTest lists every single test. As wasm it lists one entry an executable: a Node process
# for each test would cost more than the tests.
set(tests "${CMAKE_CURRENT_SOURCE_DIR}/tests")
file(GLOB_RECURSE test_files CONFIGURE_DEPENDS "${tests}/*_test.cpp")
file(GLOB_RECURSE support_files CONFIGURE_DEPENDS "${tests}/support/*.cpp")
list(FILTER support_files EXCLUDE REGEX "_test\\.cpp$")
option(APOLLONIUS_ALL_WASM_TESTS "As wasm, build all tests instead of those that differ there" OFF)
if(EMSCRIPTEN AND NOT APOLLONIUS_ALL_WASM_TESTS)
  include(WasmTests)
endif()

set(APOLLONIUS_GOOGLETEST "/usr/src/googletest" CACHE PATH "GoogleTest's sources")
if(NOT EXISTS "${APOLLONIUS_GOOGLETEST}/CMakeLists.txt")
  message(FATAL_ERROR "GoogleTest's sources are not in ${APOLLONIUS_GOOGLETEST}. Install them"
    " (Debian, Ubuntu: apt-get install libgtest-dev), pass -DAPOLLONIUS_GOOGLETEST=<folder>,"
    " or leave the tests out with -DAPOLLONIUS_TESTS=OFF.")
endif()
set(BUILD_GMOCK OFF CACHE BOOL "" FORCE)
set(INSTALL_GTEST OFF CACHE BOOL "" FORCE)
if(EMSCRIPTEN)
  set(gtest_disable_pthreads ON CACHE BOOL "" FORCE)
endif()
add_subdirectory("${APOLLONIUS_GOOGLETEST}" "${CMAKE_CURRENT_BINARY_DIR}/googletest"
  EXCLUDE_FROM_ALL SYSTEM)

# Shared by all test executables: generators, oracle, and where the data files are.
add_library(apollonius_test_support STATIC ${support_files})
target_include_directories(apollonius_test_support PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}" "${tests}")
target_compile_definitions(apollonius_test_support PUBLIC APOLLONIUS_TEST_DATA="${tests}/data")
target_link_libraries(apollonius_test_support PUBLIC apollonius apollonius_flags)

if(EMSCRIPTEN)
  # The programs are CommonJS; the repository's package.json says otherwise of .js files.
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/package.json" "{ \"type\": \"commonjs\" }\n")
  # Node's own file system, so that tests read tests/data as they do natively.
  set(wasm_test_link_options -sENVIRONMENT=node -sNODERAWFS=1 -sEXIT_RUNTIME=1)
  if(NOT APOLLONIUS_ALL_WASM_TESTS)
    # Without Binaryen's passes, which take longer than most programs run. The package's module has
    # them, and all tests do in `npm run check -- wasm`.
    list(APPEND wasm_test_link_options -O1)
  endif()
endif()

set(folders "")
foreach(file IN LISTS test_files)
  cmake_path(RELATIVE_PATH file BASE_DIRECTORY "${tests}" OUTPUT_VARIABLE relative)
  if(relative MATCHES "^([^/]+)/")
    set(folder "${CMAKE_MATCH_1}")
  else()
    set(folder core)
  endif()
  list(APPEND folders ${folder})
  list(APPEND sources_of_${folder} "${file}")
endforeach()
list(REMOVE_DUPLICATES folders)

include(GoogleTest)
list(GET folders 0 first)
foreach(folder IN LISTS folders)
  set(target ${folder}_tests)
  add_executable(${target} ${sources_of_${folder}})
  target_link_libraries(${target} PRIVATE apollonius_test_support gtest_main)
  # Compiling is two thirds of these steps of a whole run; the code that runs long is in the
  # libraries.
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  # Reading gtest.h was a third of that time natively and two thirds as wasm; the other headers are
  # a third of the rest.
  if(folder STREQUAL first)
    target_precompile_headers(${target} PRIVATE <gtest/gtest.h> <algorithm> <cmath> <span>)
  else()
    target_precompile_headers(${target} REUSE_FROM ${first}_tests)
  endif()
  if(EMSCRIPTEN)
    target_link_options(${target} PRIVATE ${wasm_test_link_options})
    add_test(NAME ${folder} COMMAND ${target})
  else()
    gtest_discover_tests(${target} DISCOVERY_MODE PRE_TEST TEST_PREFIX "${folder}/")
  endif()
endforeach()

# The recorded hashes alone, for tests/check/determinism.mjs, which builds them with many compilers
# and flags.
add_executable(determinism_tests EXCLUDE_FROM_ALL
  "${tests}/diagram/determinism_test.cpp" "${tests}/geometry/voronoi_test.cpp")
target_link_libraries(determinism_tests PRIVATE apollonius_test_support gtest_main)

if(NOT EMSCRIPTEN)
  add_test(NAME flags COMMAND "${CMAKE_COMMAND}" -DROOT=${CMAKE_CURRENT_SOURCE_DIR}
    -DWORK=${CMAKE_CURRENT_BINARY_DIR}/flags -DCXX=${CMAKE_CXX_COMPILER} -DOBJDUMP=${CMAKE_OBJDUMP}
    -DLIBRARY=$<TARGET_FILE:apollonius> -P "${tests}/flags/check.cmake")
  if(APOLLONIUS_INSTALL)
    # Flags of the library that a program that links it needs, too.
    set(flags ${CMAKE_CXX_FLAGS})
    if(APOLLONIUS_SANITIZE)
      list(APPEND flags -fsanitize=address,undefined)
    endif()
    list(JOIN flags " " flags)
    add_test(NAME install COMMAND "${CMAKE_COMMAND}" -DROOT=${CMAKE_CURRENT_SOURCE_DIR}
      -DBUILD=${CMAKE_CURRENT_BINARY_DIR} -DCONFIG=$<CONFIG> -DCXX=${CMAKE_CXX_COMPILER}
      -DVERSION=${PROJECT_VERSION} "-DFLAGS=${flags}" -P "${tests}/install/check.cmake")
  endif()
endif()

# Exactness at scale, by hand: see the top of the file.
add_executable(predicate_scale EXCLUDE_FROM_ALL "${tests}/scale/predicate_scale.cpp")
target_link_libraries(predicate_scale PRIVATE apollonius_test_support)

# Fuzz targets: with libFuzzer, or natively as programs that replay their corpus.
file(GLOB fuzz_files CONFIGURE_DEPENDS "${tests}/fuzz/*_fuzz.cpp")
set(corpora "${CMAKE_CURRENT_BINARY_DIR}/corpus")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${tests}/fuzz/corpus.tar.gz")
file(REMOVE_RECURSE "${corpora}")
file(ARCHIVE_EXTRACT INPUT "${tests}/fuzz/corpus.tar.gz" DESTINATION "${corpora}")
foreach(file IN LISTS fuzz_files)
  cmake_path(GET file STEM name)
  set(corpus "${corpora}/${name}")
  if(APOLLONIUS_FUZZ)
    add_executable(${name} "${file}")
    target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  elseif(NOT EMSCRIPTEN AND EXISTS "${corpus}")
    add_executable(${name} "${file}" "${tests}/fuzz/replay.cpp")
    add_test(NAME fuzz/${name} COMMAND ${name} "${corpus}")
  else()
    continue()
  endif()
  # Some helpers use macros of GoogleTest.
  target_link_libraries(${name} PRIVATE apollonius_test_support gtest)
endforeach()
