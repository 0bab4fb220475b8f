# One set of flags for every target, native and wasm, as an interface target `apollonius_flags`.
#
# Contraction is off and fast-math stays off because the error bounds of the predicates count each
# rounding; with both, + - * / and sqrt give the same bits under g++, clang++ and wasm, and so does
# everything that is computed with them. Flags of the machine (-march=native, -mfma) are fine with
# contraction off. Flags that change arithmetic are refused. Ours come later on the compiler's
# command line and would win there, but the linker does not get them, and with -ffast-math it
# switches subnormals off for the whole program.
function(apollonius_refuse_other_arithmetic)
  get_directory_property(compile_options COMPILE_OPTIONS)
  get_directory_property(link_options LINK_OPTIONS)
  set(asked ${CMAKE_CXX_COMPILER_ARG1} ${compile_options} ${link_options} ${CMAKE_CXX_FLAGS}
    ${CMAKE_EXE_LINKER_FLAGS} ${CMAKE_SHARED_LINKER_FLAGS})
  foreach(config IN ITEMS ${CMAKE_BUILD_TYPE} ${CMAKE_CONFIGURATION_TYPES})
    string(TOUPPER "${config}" config)
    list(APPEND asked ${CMAKE_CXX_FLAGS_${config}} ${CMAKE_EXE_LINKER_FLAGS_${config}}
      ${CMAKE_SHARED_LINKER_FLAGS_${config}})
  endforeach()
  string(JOIN "|" forbidden
    "Ofast|ffast-math|funsafe-math-optimizations|fassociative-math|freciprocal-math"
    "ffinite-math-only|fno-signed-zeros|fcx-limited-range|fsingle-precision-constant"
    "ffp-contract=(on|fast.*)|ffp-model=(fast|aggressive)"
    "mfpmath=(387|both|.*[,+].*)|mdaz-ftz|mno-sse2?")
  string(REGEX REPLACE "[;: ]+" ";" asked "${asked}")
  foreach(option IN LISTS asked)
    if(option MATCHES "^-(${forbidden})$")
      message(FATAL_ERROR "apollonius: ${option} changes arithmetic, on which the exactness of"
        " every answer rests. Remove it from CMAKE_CXX_FLAGS, CXXFLAGS or wherever it is added"
        " (-march=native and -mfma are fine).")
    endif()
  endforeach()
endfunction()
apollonius_refuse_other_arithmetic()

add_library(apollonius_flags INTERFACE)
target_compile_options(apollonius_flags INTERFACE
  # One item: CMake removes a flag that occurred before, and so would not put it at the end.
  "SHELL:-ffp-contract=off -fno-fast-math -fno-math-errno -fno-trapping-math"
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wold-style-cast -Wcast-qual
  -Wcast-align -Wextra-semi -Wformat=2 -Wimplicit-fallthrough -Wnon-virtual-dtor
  -Woverloaded-virtual -Wundef)
if(APOLLONIUS_WERROR)
  target_compile_options(apollonius_flags INTERFACE -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU"
    AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|i.86|x86)$")
  # g++ 12 turns alternating differences and sums of products into vfmaddsub even with contraction
  # off. Without the instructions it cannot.
  target_compile_options(apollonius_flags INTERFACE "SHELL:-mno-fma -mno-fma4 -mno-avx512f")
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # g++ 12 sees one in every "..." + std::string.
  target_compile_options(apollonius_flags INTERFACE -Wno-restrict)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Boost's shift of integers of fixed length, inlined into ours: g++ 12 takes the length for 0.
  target_compile_options(apollonius_flags INTERFACE -Wno-aggressive-loop-optimizations)
endif()
# Also with -m32 on a 64-bit machine, whose name then still is that of the machine.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|i.86|x86)$" AND CMAKE_SIZEOF_VOID_P EQUAL 4
    AND NOT EMSCRIPTEN)
  # x87 would round to 80 bits.
  target_compile_options(apollonius_flags INTERFACE -msse2 -mfpmath=sse)
endif()
# Long multiplication only: from more limbs on than a Dyadic has (number/dyadic.h), and than fit
# the type that counts them.
target_compile_definitions(apollonius_flags INTERFACE
  BOOST_MP_STANDALONE BOOST_MP_KARATSUBA_CUTOFF=65536)
if(APOLLONIUS_BOOST_FOUND)
  target_include_directories(apollonius_flags SYSTEM INTERFACE "${APOLLONIUS_BOOST_FOUND}")
endif()
if(APOLLONIUS_SHADOW_CHECK)
  set(shadow_check_every 1)
  if(APOLLONIUS_SHADOW_CHECK MATCHES "^[0-9]+$")
    set(shadow_check_every ${APOLLONIUS_SHADOW_CHECK})
  endif()
  target_compile_definitions(apollonius_flags
    INTERFACE APOLLONIUS_SHADOW_CHECK=${shadow_check_every})
endif()

# Options that must reach GoogleTest too, because object files with and without them do not mix.
string(REPLACE "-O2" "-O3" CMAKE_CXX_FLAGS_RELEASE "${CMAKE_CXX_FLAGS_RELEASE}")
if(EMSCRIPTEN)
  # One level for the package's module and the tests, except a few files (CMakeLists.txt): -O2 and
  # -O3 exceed the size that a page may load (bench/README.md, "Size").
  string(REPLACE "-O3" "-Os" CMAKE_CXX_FLAGS_RELEASE "${CMAKE_CXX_FLAGS_RELEASE}")
  # SIMD is the youngest feature that a browser needs (2021; Safari 2023): features that came with
  # it or before may be used too.
  add_compile_options(-fwasm-exceptions -msimd128 -mbulk-memory -mnontrapping-fptoint -msign-ext)
  add_link_options(-fwasm-exceptions -mbulk-memory
    -sALLOW_MEMORY_GROWTH -sMAXIMUM_MEMORY=4GB -sSTACK_SIZE=1MB)
endif()
if(APOLLONIUS_SANITIZE)
  # With assertions, and those of the standard library: AddressSanitizer does not see an index that
  # is beyond a vector's size but in its room.
  add_compile_options(-UNDEBUG -D_GLIBCXX_ASSERTIONS)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined
    -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=address,undefined)
endif()
if(APOLLONIUS_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "APOLLONIUS_FUZZ needs clang++: pass -DCMAKE_CXX_COMPILER=clang++-14")
  endif()
  add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined
    -fno-omit-frame-pointer -g)
  add_link_options(-fsanitize=address,undefined)
endif()
