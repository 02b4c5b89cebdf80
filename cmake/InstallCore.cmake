# `cmake --install` gives a package that find_package(gjkscope) finds: the core, as gjkscope::gjk.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_DATADIR}/cmake/gjkscope)

set_target_properties(gjkscope_gjk PROPERTIES EXPORT_NAME gjk)
install(TARGETS gjkscope_gjk EXPORT gjkscope-targets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/gjk/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gjk COMPONENT dev FILES_MATCHING PATTERN "*.hpp")
install(FILES ${PROJECT_SOURCE_DIR}/src/judge/gjkscope_log.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
install(EXPORT gjkscope-targets NAMESPACE gjkscope:: DESTINATION ${package} COMPONENT dev)

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/gjkscope-config.cmake.in gjkscope-config.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(gjkscope-config-version.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/gjkscope-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/gjkscope-config-version.cmake
        DESTINATION ${package} COMPONENT dev)
configure_file(${PROJECT_SOURCE_DIR}/cmake/gjkscope.pc.in gjkscope.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/gjkscope.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig COMPONENT dev)
