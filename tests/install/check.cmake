# Checks that others can use the library: a CTest script, after a build in the folder BUILD.
# Installs it into an empty folder, and builds and runs a program with the installed files; compiles
# the same program with the library's sources as a part of its project. Takes -DROOT= -DBUILD=
# -DCONFIG= -DCXX= -DVERSION= -DFLAGS=
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}: ${result}: ${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(work "${BUILD}/install")
set(prefix "${work}/prefix")
file(REMOVE_RECURSE "${work}")

# --- Installed ------------------------------------------------------------------------------------
run("${CMAKE_COMMAND}" --install "${BUILD}" --config "${CONFIG}" --prefix "${prefix}")

file(GLOB headers RELATIVE "${prefix}/include" "${prefix}/include/*")
if(NOT headers STREQUAL "apollonius")
  message(SEND_ERROR "installed beside <apollonius/...>: ${headers}")
endif()
file(GLOB_RECURSE config "${prefix}/*.cmake")
foreach(file IN LISTS config)
  file(READ "${file}" text)
  # The package may be moved; its users need no Boost and get no flags of ours.
  string(FIND "${text}" "${ROOT}" root)
  if(NOT root EQUAL -1 OR text MATCHES "apollonius_flags|[Bb]oost|BOOST|-Wall|-Werror|-ffp")
    message(SEND_ERROR "${file} has what its users do not need: ${CMAKE_MATCH_0}\n${text}")
  endif()
endforeach()

set(configure "${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" "-DCMAKE_CXX_COMPILER=${CXX}"
  -DCMAKE_BUILD_TYPE=Release)
# Also linked with -ffast-math, which the library's target takes back (its arithmetic needs
# subnormals, and looks for them).
foreach(flags IN ITEMS "" " -ffast-math")
  run(${configure} -B "${work}/installed" --fresh "-DCMAKE_PREFIX_PATH=${prefix}"
    "-DVERSION=${VERSION}" "-DCMAKE_CXX_FLAGS=${FLAGS}${flags}")
  run("${CMAKE_COMMAND}" --build "${work}/installed")
  run("${work}/installed/consumer")
  if(NOT output MATCHES "^site 0 at 2, area [0-9]+\\.[0-9]+\n$")
    message(SEND_ERROR "the program that was linked${flags} says: ${output}")
  endif()
endforeach()

# --- As a part of another project -----------------------------------------------------------------
# The library itself is not compiled once more.
set(build "${work}/subdirectory")
run(${configure} -B "${build}" "-DSUBDIRECTORY=${ROOT}")
run("${CMAKE_COMMAND}" --build "${build}" --target help)
if(output MATCHES "_tests|bench")
  message(SEND_ERROR "targets in a user's project that are not for users: ${output}")
endif()
file(READ "${build}/compile_commands.json" commands)
string(JSON count LENGTH "${commands}")
math(EXPR last "${count} - 1")
foreach(k RANGE ${last})
  string(JSON file GET "${commands}" ${k} file)
  if(file MATCHES "/main\\.cpp$")
    string(JSON command GET "${commands}" ${k} command)
    string(JSON folder GET "${commands}" ${k} directory)
  endif()
endforeach()
if(command MATCHES "-Wold-style-cast|-ffp-contract|BOOST|boost")
  message(SEND_ERROR "flags that are not for users: ${command}")
endif()
separate_arguments(command UNIX_COMMAND "${command}")
list(REMOVE_ITEM command -o -c)
list(FILTER command EXCLUDE REGEX "\\.o$")
execute_process(COMMAND ${command} -fsyntax-only WORKING_DIRECTORY "${folder}"
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(SEND_ERROR "compiled as a part of another project: ${output}")
endif()
