# Two packages by CPack: gpuwars_*.deb (components game, debian_game) and libgpuwars-dev_*.deb (gpu, debian_gpu). What
# only Debian wants is in components of its own, so that `cmake --install` leaves it out.
set(gw_debian ${CMAKE_CURRENT_LIST_DIR}/debian)
# The project has no address of its own: who publishes packages names one, under which users reach them.
set(GW_PACKAGE_CONTACT "The GpuWars developers <developers@gpuwars.invalid>" CACHE STRING
  "Maintainer of the packages: Name <address>")
if(NOT GW_PACKAGE_CONTACT MATCHES "^[^<>\n]+ <[^<> @]+@[^<> @]+>$")
  message(FATAL_ERROR "GW_PACKAGE_CONTACT is '${GW_PACKAGE_CONTACT}': write it as \"Name <address>\".")
endif()
set(gw_changelog ${PROJECT_BINARY_DIR}/package/changelog)
configure_file(${gw_debian}/changelog.in ${gw_changelog} @ONLY)
foreach(package gpuwars libgpuwars-dev)
  set(component debian_game)
  if(package STREQUAL "libgpuwars-dev")
    set(component debian_gpu)
  endif()
  install(FILES ${gw_debian}/copyright ${gw_changelog} DESTINATION share/doc/${package} COMPONENT ${component})
  if(EXISTS ${gw_debian}/${package}.lintian-overrides)
    install(FILES ${gw_debian}/${package}.lintian-overrides DESTINATION share/lintian/overrides RENAME ${package}
      COMPONENT ${component})
  endif()
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/examples DESTINATION share/doc/libgpuwars-dev COMPONENT debian_gpu
  PATTERN build EXCLUDE)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME gpuwars)
set(CPACK_PACKAGE_VENDOR "The GpuWars developers")
set(CPACK_PACKAGE_CONTACT "${GW_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR})
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_COMPONENTS_ALL game debian_game gpu debian_gpu)
# These run while the packages are made: the first gives everything the changelog's date, the second does to the files
# what Debian's policy asks for.
configure_file(${gw_debian}/cpack_options.cmake.in ${PROJECT_BINARY_DIR}/package/cpack_options.cmake @ONLY)
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_BINARY_DIR}/package/cpack_options.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${gw_debian}/finish_files.cmake)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME gpuwars)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION games)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "twin-stick shooter whose whole simulation runs as GPU kernels
You are a GPUship inside the computer universe and process (shoot) what a
GPU processes: up to 8,192 enemies, more if you ask, and each of them thinks,
moves and collides sixty times a second.

With an NVIDIA GPU the kernels run there when the package was built with
CUDA; else they run on the processor, with the same results, bit for bit.
Replays can be watched, verified tick by tick and made into films.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${gw_packaged}/${gw_kernel_folder})
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libgl1-mesa-dri")
# Films are encoded by ffmpeg; rsvg-convert makes PNG of the pictures of profiles.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "ffmpeg, librsvg2-bin, fonts-dejavu-core")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libgpuwars-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "neighbour search and sorting as kernels, for CUDA and for processors
The compute side of the game GpuWars as a library of its own: a layer that
runs one kernel source on NVIDIA GPUs and on processors with the same
results, bit for bit; on it the NGrid, a neighbourhood structure with
exactly one entity per cell, uniform grids, neighbour lists, scans and sorts.

Headers, static libraries and the files for CMake and pkg-config.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "g++ | c++-compiler")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SUGGESTS "cmake, pkgconf")

include(CPack)
cpack_add_component_group(program DISPLAY_NAME gpuwars)
cpack_add_component_group(library DISPLAY_NAME libgpuwars-dev)
cpack_add_component(game GROUP program)
cpack_add_component(debian_game GROUP program)
cpack_add_component(gpu GROUP library)
cpack_add_component(debian_gpu GROUP library)
