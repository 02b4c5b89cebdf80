# Everything beyond Eigen, which the core finds for itself. scripts/packages.txt lists the Debian packages.

find_package(PkgConfig REQUIRED)
if(POLICY CMP0167)
  cmake_policy(SET CMP0167 NEW)  # Boost says itself where it is
endif()
find_package(Boost REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Threads REQUIRED)
pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
pkg_check_modules(sdl2 REQUIRED IMPORTED_TARGET sdl2)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo cairo-pdf cairo-ft)
pkg_check_modules(fontconfig REQUIRED IMPORTED_TARGET fontconfig)
pkg_check_modules(deflate REQUIRED IMPORTED_TARGET libdeflate)
pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET tomlplusplus)
pkg_check_modules(stb REQUIRED IMPORTED_TARGET stb)
find_path(CLI11_INCLUDE_DIR CLI/CLI.hpp REQUIRED)
find_package(GIF REQUIRED)
# Headers alone: the libraries are looked for at run time.
find_path(GL_INCLUDE_DIR GL/gl.h REQUIRED)
find_path(EGL_INCLUDE_DIR EGL/eglext.h REQUIRED)
