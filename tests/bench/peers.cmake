# Libraries that the core is compared with; each that is found becomes a target bench_NAME. None is needed.

# bench_peer(NAME LIBRARY...): NAME.cpp, which alone sees the library's headers.
function(bench_peer name)
  string(TOUPPER ${name} macro)
  add_library(bench_${name} STATIC ${name}.cpp)
  target_link_libraries(bench_${name} PUBLIC gjkscope::gjk PRIVATE gjkscope::flags ${ARGN})
  target_compile_definitions(bench_${name} INTERFACE GJKSCOPE_${macro})
endfunction()

# Box2D 2 and 3 name their target and their folder of headers alike, so 2 is found by hand, by files that 3 does not have.
find_path(BOX2D_2_INCLUDE_DIR box2d/b2_distance.h)
find_library(BOX2D_2_LIBRARY NAMES libbox2d.so.2)
if(BOX2D_2_INCLUDE_DIR AND BOX2D_2_LIBRARY)
  bench_peer(box2d_2 ${BOX2D_2_LIBRARY})
  target_include_directories(bench_box2d_2 SYSTEM PRIVATE ${BOX2D_2_INCLUDE_DIR})
endif()

find_package(box2d 3 CONFIG QUIET)
if(box2d_FOUND)
  bench_peer(box2d_3 box2d::box2d)
endif()
