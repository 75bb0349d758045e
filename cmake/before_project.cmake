# Checks that must come before CMake's own, whose messages help less.
if(CMAKE_VERSION VERSION_LESS 3.22)
  message(FATAL_ERROR "GpuWars needs CMake 3.22 or newer, and this is ${CMAKE_VERSION}: install a newer package cmake "
    "(Debian 12 and Ubuntu 22.04 have one), or the one of 'pip install cmake'.")
endif()
if(" ${CMAKE_CXX_FLAGS} $ENV{CXXFLAGS} " MATCHES " -m(32|x32) ")
  message(FATAL_ERROR "GpuWars is built for 64-bit x86-64 and AArch64 only, and there is -m${CMAKE_MATCH_1} in "
    "CMAKE_CXX_FLAGS or CXXFLAGS: leave it out.")
endif()
