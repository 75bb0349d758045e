# ccache in front of both compilers when it is there: a rebuild after a branch switch is then cheap. It takes what a file
# has read from the compiler (depend mode) instead of preprocessing everything once more, and accepts precompiled headers.
# Paths below the sources count as relative ones: build folders beside each other, and clones, share what is the same.
find_program(GW_CCACHE ccache)
if(GW_CCACHE)
  set(gw_launcher env CCACHE_DEPEND=true CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_SLOPPINESS=pch_defines,time_macros ${GW_CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${gw_launcher})
  set(CMAKE_CUDA_COMPILER_LAUNCHER ${gw_launcher})
endif()
