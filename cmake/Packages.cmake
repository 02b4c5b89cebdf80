# Everything beyond Eigen, which the core finds for itself. scripts/packages.txt lists the Debian packages.

find_package(PkgConfig REQUIRED)
find_package(Boost REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Threads REQUIRED)
pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
pkg_check_modules(sdl2 REQUIRED IMPORTED_TARGET sdl2)
pkg_check_modules(osmesa REQUIRED IMPORTED_TARGET osmesa)
pkg_check_modules(deflate REQUIRED IMPORTED_TARGET libdeflate)
pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET tomlplusplus)
pkg_check_modules(stb REQUIRED IMPORTED_TARGET stb)
find_path(CLI11_INCLUDE_DIR CLI/CLI.hpp REQUIRED)
