# ccache in front of both compilers when it is there: a rebuild after a branch switch is then cheap.
find_program(GW_CCACHE ccache)
if(GW_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${GW_CCACHE})
  set(CMAKE_CUDA_COMPILER_LAUNCHER ${GW_CCACHE})
endif()
