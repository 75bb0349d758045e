# A fifth of ./check's work was once to read the headers of GoogleTest and of the standard library 180 times, and to optimise
# tests that run once. Every program that uses GoogleTest therefore shares those headers, compiled once, and every program
# of tests/ is optimised lightly: what it tests lies in libraries, and those are optimised as ever. GW_SHARED_HEADERS=OFF
# compiles each file by itself, so that one that forgets an include is found: ./check --full builds so with clang.
option(GW_SHARED_HEADERS "Compile the headers that test programs share once for all of them" ON)

set(gw_light_optimisation $<$<CONFIG:Release>:-O1>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # At -O1 gcc 12 sees copies beyond the end of "text" + std::string.
  foreach(alarm IN ITEMS array-bounds stringop-overflow stringop-overread)
    list(APPEND gw_light_optimisation $<$<CONFIG:Release>:-Wno-${alarm}>)
  endforeach()
endif()

if(GW_SHARED_HEADERS)
  find_path(GW_RAPIDCHECK_INCLUDE_DIR rapidcheck/gtest.h REQUIRED)
  add_library(gw_test_headers OBJECT shared_headers.cpp)
  target_include_directories(gw_test_headers SYSTEM PRIVATE ${GW_RAPIDCHECK_INCLUDE_DIR})
  target_compile_options(gw_test_headers PRIVATE ${gw_light_optimisation})
  target_link_libraries(gw_test_headers PRIVATE gw_options GTest::gtest)
  target_precompile_headers(gw_test_headers PRIVATE
    <gtest/gtest.h> <algorithm> <array> <chrono> <cmath> <filesystem> <fstream> <functional> <map> <memory> <numeric>
    <optional> <random> <set> <span> <sstream> <string> <thread> <unordered_map> <vector> <rapidcheck/gtest.h>)
endif()

# Every program of a folder and those below.
function(gw_hasten_tests folder)
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(below IN LISTS folders)
    gw_hasten_tests(${below})
  endforeach()
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL EXECUTABLE)
      target_compile_options(${target} PRIVATE ${gw_light_optimisation})
      get_target_property(libraries ${target} LINK_LIBRARIES)
      if(libraries MATCHES "GTest::gtest")
        add_dependencies(unit_tests ${target})
        if(GW_SHARED_HEADERS)
          target_precompile_headers(${target} REUSE_FROM gw_test_headers)
        endif()
      endif()
    endif()
  endforeach()
endfunction()
