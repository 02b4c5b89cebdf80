# For the preset "wasm": headers alone, seen through a folder of links, since /usr/include itself holds
# the machine's own C library.

set(headers ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(name boost fmt nlohmann toml++ stb)
  if(NOT EXISTS /usr/include/${name})
    message(FATAL_ERROR "there is no /usr/include/${name}; scripts/setup build installs it")
  endif()
  file(CREATE_LINK /usr/include/${name} ${headers}/${name} SYMBOLIC)
endforeach()

foreach(target Boost::headers fmt::fmt nlohmann_json::nlohmann_json PkgConfig::tomlplusplus PkgConfig::stb)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE ${headers})
endforeach()
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
