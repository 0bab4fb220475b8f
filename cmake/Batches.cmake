# Compiles several sources as one, because headers are most of what a file is compiled from. Each
# folder is a batch; files of it that have compile options of their own are a batch for each list of
# options. A batch has the path of its folder, by which the wasm module is cut into parts
# (tools/toolchain/split_wasm.mjs).

# Sets `result` to the files to compile instead of `sources`.
function(apollonius_batches sources result)
  set(batches "")  # the text of each is in the variable of its name
  foreach(source IN LISTS sources)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
      OUTPUT_VARIABLE path)
    cmake_path(GET path PARENT_PATH folder)
    get_source_file_property(options "${source}" COMPILE_OPTIONS)
    if(NOT options)
      set(options "")
    endif()
    set(batch "${CMAKE_CURRENT_BINARY_DIR}/batches/${folder}/all${options}.cpp")
    if(NOT batch IN_LIST batches)
      list(APPEND batches "${batch}")
      set("${batch}" "")
      set_source_files_properties("${batch}" PROPERTIES COMPILE_OPTIONS "${options}")
    endif()
    string(APPEND "${batch}" "#include \"${source}\"\n")
  endforeach()
  foreach(batch IN LISTS batches)
    file(CONFIGURE OUTPUT "${batch}" CONTENT "${${batch}}" @ONLY)
  endforeach()
  set(${result} ${batches} PARENT_SCOPE)
endfunction()
