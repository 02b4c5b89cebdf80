# `cmake --install` gives a package that find_package(gjkscope) finds: gjkscope::gjk, and unless core-only the command with its
# lessons and assets.

include(CMakePackageConfigHelpers)

install(TARGETS gjkscope_gjk EXPORT gjkscope-targets)
install(DIRECTORY src/gjk/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gjk FILES_MATCHING PATTERN "*.hpp")
install(EXPORT gjkscope-targets NAMESPACE gjkscope:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/gjkscope)
configure_package_config_file(cmake/gjkscope-config.cmake.in gjkscope-config.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/gjkscope)
write_basic_package_version_file(gjkscope-config-version.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/gjkscope-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/gjkscope-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/gjkscope)

if(NOT GJKSCOPE_CORE_ONLY)
  install(TARGETS gjkscope gjkscope-viewer RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(DIRECTORY lessons assets DESTINATION ${CMAKE_INSTALL_DATADIR}/gjkscope)
  # Cases that the study asks about.
  install(DIRECTORY tests/hard-cases DESTINATION ${CMAKE_INSTALL_DATADIR}/gjkscope/tests)
endif()
