# Libraries that the core is compared with. Each one that is found becomes part of bench_libraries; none is needed.

add_library(bench_libraries STATIC libraries.cpp)
target_link_libraries(bench_libraries PUBLIC gjkscope::gjk PRIVATE gjkscope::flags)
target_include_directories(bench_libraries PUBLIC ${PROJECT_SOURCE_DIR}/tests)

# bench_peer(NAME VERSION LIBRARY...): NAME.cpp, which alone sees the library's headers.
function(bench_peer name version)
  string(TOUPPER ${name} macro)
  add_library(bench_${name} OBJECT ${name}.cpp)
  target_link_libraries(bench_${name} PRIVATE gjkscope::gjk gjkscope::flags ${ARGN})
  target_include_directories(bench_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(bench_${name} PRIVATE PEER_VERSION="${version}")
  target_sources(bench_libraries PRIVATE $<TARGET_OBJECTS:bench_${name}>)
  target_link_libraries(bench_libraries PRIVATE ${ARGN})
  target_compile_definitions(bench_libraries PUBLIC GJKSCOPE_${macro})
endfunction()

# bench_depths(NAME VERSION LIBRARY): NAME_depths.cpp as a part of depth-compare, where the library was found.
function(bench_depths name version library)
  if(NOT version)
    return()
  endif()
  string(TOUPPER ${name} macro)
  target_sources(depth-compare PRIVATE ${name}_depths.cpp)
  set_source_files_properties(${name}_depths.cpp PROPERTIES COMPILE_DEFINITIONS PEER_VERSION="${version}")
  target_link_libraries(depth-compare PRIVATE ${library})
  target_compile_definitions(depth-compare PRIVATE GJKSCOPE_${macro})
endfunction()

# Box2D 2 and 3 name their target and their folder of headers alike, so 2 is found by files that 3 does not have.
find_path(BOX2D_2_INCLUDE_DIR box2d/b2_distance.h)
find_library(BOX2D_2_LIBRARY NAMES libbox2d.so.2)
if(BOX2D_2_INCLUDE_DIR AND BOX2D_2_LIBRARY)
  bench_peer(box2d_2 2.4 ${BOX2D_2_LIBRARY})
  target_include_directories(bench_box2d_2 SYSTEM PRIVATE ${BOX2D_2_INCLUDE_DIR})
endif()

find_package(box2d 3 CONFIG QUIET)
if(box2d_FOUND)
  bench_peer(box2d_3 ${box2d_VERSION} box2d::box2d)
endif()

find_package(ccd CONFIG QUIET)
if(ccd_FOUND)
  bench_peer(ccd ${ccd_VERSION} ccd)
endif()

find_package(fcl CONFIG QUIET)
if(fcl_FOUND)
  bench_peer(fcl ${fcl_VERSION} fcl)
endif()

pkg_check_modules(bullet QUIET IMPORTED_TARGET bullet)
if(bullet_FOUND)
  bench_peer(bullet ${bullet_VERSION} PkgConfig::bullet)
endif()

# It installs nothing: -DOPENGJK_INCLUDE_DIR and -DOPENGJK_LIBRARY tell where it is. In double, as its folder scalar is built.
find_path(OPENGJK_INCLUDE_DIR openGJK/openGJK.h)
find_library(OPENGJK_LIBRARY NAMES opengjk_scalar_static opengjk_scalar)
if(OPENGJK_INCLUDE_DIR AND OPENGJK_LIBRARY)
  bench_peer(opengjk "" ${OPENGJK_LIBRARY})
  target_include_directories(bench_opengjk SYSTEM PRIVATE ${OPENGJK_INCLUDE_DIR})
endif()
