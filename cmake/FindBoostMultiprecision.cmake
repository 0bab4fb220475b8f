# Finds Boost's multiprecision headers (header-only, used without the rest of Boost) and puts their
# folder into APOLLONIUS_BOOST_FOUND; that stays empty where the compiler finds them without any
# flag.
#
# Order: -DAPOLLONIUS_BOOST_INCLUDE, the project's own toolchain folder (filled by
# tools/toolchain/setup.mjs), the system. A wasm build never looks at the system's: /usr/include
# must not be on its include path.

# Compares BOOST_VERSION in a folder with the oldest one that has BOOST_MP_STANDALONE as we use it.
function(apollonius_boost_usable folder result)
  set(${result} FALSE PARENT_SCOPE)
  if(EXISTS "${folder}/boost/version.hpp" AND EXISTS "${folder}/boost/multiprecision/cpp_int.hpp")
    file(STRINGS "${folder}/boost/version.hpp" line REGEX "^#define BOOST_VERSION [0-9]+")
    string(REGEX MATCH "[0-9]+$" version "${line}")
    if(version GREATER_EQUAL 108000)
      set(${result} TRUE PARENT_SCOPE)
    endif()
  endif()
endfunction()

set(APOLLONIUS_BOOST_FOUND "")
set(usable FALSE)
if(APOLLONIUS_BOOST_INCLUDE)
  set(candidates "${APOLLONIUS_BOOST_INCLUDE}")
else()
  if(DEFINED ENV{APOLLONIUS_TOOLCHAIN})
    set(toolchain "$ENV{APOLLONIUS_TOOLCHAIN}")
  elseif(DEFINED ENV{XDG_CACHE_HOME})
    set(toolchain "$ENV{XDG_CACHE_HOME}/apollonius-diagram/toolchain")
  else()
    set(toolchain "$ENV{HOME}/.cache/apollonius-diagram/toolchain")
  endif()
  set(candidates "${toolchain}/boost/include")
endif()
foreach(candidate IN LISTS candidates)
  apollonius_boost_usable("${candidate}" usable)
  if(usable)
    set(APOLLONIUS_BOOST_FOUND "${candidate}")
    break()
  endif()
endforeach()
if(NOT usable AND NOT EMSCRIPTEN AND NOT APOLLONIUS_BOOST_INCLUDE)
  foreach(candidate IN ITEMS /usr/local/include /usr/include)
    apollonius_boost_usable("${candidate}" usable)
    if(usable)
      break()
    endif()
  endforeach()
endif()
if(NOT usable)
  message(FATAL_ERROR
    "Boost's multiprecision headers (Boost 1.80 or newer) were not found in: ${candidates}"
    " nor in the system's include folders.\n"
    "Run `node tools/toolchain/setup.mjs boost` (fetches them through apt into a private folder),"
    " or install Boost >= 1.80 (Debian 12: apt-get install libboost1.81-dev), or pass"
    " -DAPOLLONIUS_BOOST_INCLUDE=<folder that holds boost/>.")
endif()
