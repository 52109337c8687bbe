# cmake --install: the libraries with their headers as a package for find_package(ringlet), the
# program, and its scenes.
include(CMakePackageConfigHelpers)

set(ringlet_libraries core energies solvers collision plugins)
set(ringlet_cmake_folder ${CMAKE_INSTALL_LIBDIR}/cmake/ringlet)

foreach(name IN LISTS ringlet_libraries)
  install(TARGETS ringlet_${name} EXPORT ringlet)
  set_target_properties(ringlet_${name} PROPERTIES INSTALL_RPATH "$ORIGIN")
  install(DIRECTORY ${name}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ringlet/${name}
          FILES_MATCHING PATTERN "*.h")
endforeach()
install(EXPORT ringlet FILE ringletTargets.cmake NAMESPACE ringlet:: DESTINATION
        ${ringlet_cmake_folder})

file(RELATIVE_PATH libraries_from_program ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
set_target_properties(ringlet PROPERTIES INSTALL_RPATH "$ORIGIN/${libraries_from_program}")
install(TARGETS ringlet)
install(DIRECTORY apps/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/ringlet)

configure_package_config_file(cmake/ringletConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/ringletConfig.cmake
                              INSTALL_DESTINATION ${ringlet_cmake_folder}
                              PATH_VARS CMAKE_INSTALL_BINDIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ringletConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ringletConfig.cmake
              ${PROJECT_BINARY_DIR}/ringletConfigVersion.cmake
              cmake/RingletPlugin.cmake
        DESTINATION ${ringlet_cmake_folder})
