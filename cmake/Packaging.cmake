# What `cpack` makes: gjkscope and gjkscope-dev for Debian, and a tarball of both.

find_program(GZIP gzip)
if(NOT GZIP)
  return()
endif()
foreach(file changelog gjkscope.1 gjkscope-viewer.1)
  execute_process(COMMAND ${GZIP} -9nc ${PROJECT_SOURCE_DIR}/packaging/${file}
                  OUTPUT_FILE ${PROJECT_BINARY_DIR}/packaging-${file}.gz)
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/packaging-changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/gjkscope
        RENAME changelog.gz COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/packaging-changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/gjkscope-dev
        RENAME changelog.gz COMPONENT dev)
foreach(page gjkscope.1 gjkscope-viewer.1)
  install(FILES ${PROJECT_BINARY_DIR}/packaging-${page}.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
          RENAME ${page}.gz COMPONENT program)
endforeach()
install(FILES packaging/gjkscope.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT program)
install(FILES packaging/gjkscope.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT program)
install(FILES packaging/completions/gjkscope.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        RENAME gjkscope COMPONENT program)
install(FILES packaging/completions/_gjkscope DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
install(FILES packaging/completions/gjkscope.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
        COMPONENT program)
install(FILES packaging/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/gjkscope COMPONENT program)
install(FILES packaging/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/gjkscope-dev COMPONENT dev)

set(CPACK_GENERATOR DEB TGZ)
set(CPACK_COMPONENTS_ALL program dev)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGE_NAME gjkscope)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "step-through visualizer of the GJK distance algorithm")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGE_CONTACT "gjkscope <gjkscope@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME gjkscope)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION education)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "fonts-inter, fonts-dejavu-core, fonts-jetbrains-mono")
# Looked for at run time: the window's OpenGL.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libgl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "ffmpeg, libosmesa6, libegl1")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Lessons, a window and exports that show the GJK distance algorithm
decision by decision.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME gjkscope-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS libeigen3-dev)
set(CPACK_COMPONENT_DEV_DESCRIPTION "The header-only C++20 core of gjkscope, for programs of one's own.")
include(CPack)
