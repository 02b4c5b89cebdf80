# After add_subdirectory(gjkscope) a build has one target more, and is as it was.

# wanted(WHAT IS SHALL_BE)
function(wanted what is shall_be)
  if(NOT "${is}" STREQUAL "${shall_be}")
    message(SEND_ERROR "${what}: '${is}' instead of '${shall_be}'")
  endif()
endfunction()

# all_of(PROPERTY FOLDER RESULT): of the folder and those below it.
function(all_of property folder result)
  get_property(all DIRECTORY ${folder} PROPERTY ${property})
  get_property(below DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(subfolder IN LISTS below)
    all_of(${property} ${subfolder} more)
    list(APPEND all ${more})
  endforeach()
  set(${result} ${all} PARENT_SCOPE)
endfunction()

all_of(BUILDSYSTEM_TARGETS ${GJKSCOPE_SOURCES} targets)
wanted("targets" "${targets}" gjkscope_gjk)
all_of(TESTS ${GJKSCOPE_SOURCES} tests)
wanted("tests" "${tests}" "")
get_target_property(options gjkscope::gjk INTERFACE_COMPILE_OPTIONS)
wanted("compile options" "${options}" options-NOTFOUND)
get_target_property(libraries gjkscope::gjk INTERFACE_LINK_LIBRARIES)
wanted("libraries" "${libraries}" Eigen3::Eigen)

foreach(variable CMAKE_BUILD_TYPE CMAKE_CXX_STANDARD CMAKE_CXX_EXTENSIONS CMAKE_CXX_COMPILER_LAUNCHER CMAKE_MODULE_PATH
                 CMAKE_RUNTIME_OUTPUT_DIRECTORY CMAKE_EXPORT_COMPILE_COMMANDS)
  wanted(${variable} "${${variable}}" "")
endforeach()
get_directory_property(options COMPILE_OPTIONS)
wanted("compile options of the folder" "${options}" "")
get_cmake_property(names CACHE_VARIABLES)
list(FILTER names INCLUDE REGEX "GJKSCOPE|CCACHE|CMAKE_INSTALL_[A-Z]*DIR")
wanted("cache variables" "${names}" "GJKSCOPE_INSTALL;GJKSCOPE_SOURCES")
