# `cmake --install`: the library, its public headers as <apollonius/...>, and what find_package
# needs:
#
#   find_package(apollonius 0.1 REQUIRED)
#   target_link_libraries(program PRIVATE apollonius::apollonius)
#
# tests/install tries it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(config_folder "${CMAKE_INSTALL_LIBDIR}/cmake/apollonius")
install(TARGETS apollonius EXPORT apollonius INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/src/apollonius"
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.h")

# Nothing else is to be found for the library's users, so the exported targets are the package.
install(EXPORT apollonius NAMESPACE apollonius:: FILE apolloniusConfig.cmake
  DESTINATION "${config_folder}")
# Before 1.0, a new minor version may be incompatible.
write_basic_package_version_file(apolloniusConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/apolloniusConfigVersion.cmake"
  DESTINATION "${config_folder}")
