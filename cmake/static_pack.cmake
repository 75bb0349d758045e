# GW_STATIC: programs for machines that have a driver and little else (tests/on_gpu). Needs gw_options.
# The C++ runtime and GLEW go in (render/ takes libGLEW.a); every other library is taken as an archive
# where Debian ships one. What stays shared is gathered by tests/on_gpu --pack.
option(GW_STATIC "Link what is not on every machine statically, for self-contained headless packs" OFF)
if(GW_STATIC)
  target_link_options(gw_options INTERFACE "$<$<LINK_LANGUAGE:CXX>:-static-libstdc++;-static-libgcc>")
  set(CMAKE_FIND_LIBRARY_SUFFIXES .a .so)
  set(GLEW_USE_STATIC_LIBS ON)
endif()
