# GW_PACKAGES: what packages hold besides the program, and `cpack` to make them (docs/guide/building.md). The program that is
# installed then is not gpuwars of the build folder but its twin below packaged/, which takes the kernels of the cpu
# device from a library that exists once per kind of processor.
if(NOT GW_GAME OR NOT GW_WINDOW)
  message(FATAL_ERROR "GW_PACKAGES needs the whole game: leave GW_GAME and GW_WINDOW on, or GW_PACKAGES off.")
endif()
if(GW_NATIVE)
  message(FATAL_ERROR "GW_PACKAGES is for every processor and GW_NATIVE for one: leave one of them off.")
endif()
include(GNUInstallDirs)
include(packages/kernel_variants)
include(packages/documents)
include(packages/debian)
