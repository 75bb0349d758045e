# The kernels of the cpu device as a private library of the installed program, compiled once per kind of processor. The
# dynamic loader takes the best that this processor runs (glibc-hwcaps, glibc 2.33 and newer; older ones take the first):
#
#   LIBDIR/gpuwars/libgpuwars-cpu.so                           every processor of the architecture
#   LIBDIR/gpuwars/glibc-hwcaps/x86-64-v3/libgpuwars-cpu.so    those with AVX2
#
# Not two sets of objects in one program: the linker keeps one copy of each inline function and template, of whichever
# set, and an old processor would meet AVX2 that it does not have. A library keeps all its own to itself: the version
# script exports the seam alone (the visibility flags of the compiler do not reach templates of std).
set(gw_kernel_levels "")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$" AND CMAKE_SIZEOF_VOID_P EQUAL 8)
  set(gw_kernel_levels x86-64-v3)
endif()
set(gw_packaged ${PROJECT_BINARY_DIR}/packaged)  # laid out as it is installed, and starts from here
set(gw_kernel_folder ${CMAKE_INSTALL_LIBDIR}/gpuwars)
set(gw_kernel_exports ${CMAKE_CURRENT_LIST_DIR}/kernel_exports.map)

function(gw_place_kernels name subfolder)
  set_target_properties(${name} PROPERTIES OUTPUT_NAME gpuwars-cpu LINK_DEPENDS ${gw_kernel_exports}
    LIBRARY_OUTPUT_DIRECTORY ${gw_packaged}/${gw_kernel_folder}${subfolder})
  target_link_options(${name} PRIVATE -Wl,--version-script=${gw_kernel_exports} -Wl,-z,defs)
  target_link_libraries(${name} PRIVATE gw_gpu_host gw_options)
  install(TARGETS ${name} LIBRARY DESTINATION ${gw_kernel_folder}${subfolder} COMPONENT game)
endfunction()

# Objects of the static libraries go into a shared one.
set_target_properties(gw_gpu_host gw_gpu_cpu gw_sim_cpu PROPERTIES POSITION_INDEPENDENT_CODE ON)
add_library(gw_cpu_kernels SHARED $<TARGET_OBJECTS:gw_gpu_cpu> $<TARGET_OBJECTS:gw_sim_cpu>)
gw_place_kernels(gw_cpu_kernels "")

foreach(level IN LISTS gw_kernel_levels)
  set(sources "")
  foreach(part gw_gpu_cpu gw_sim_cpu)
    get_target_property(folder ${part} SOURCE_DIR)
    get_target_property(names ${part} SOURCES)
    foreach(name IN LISTS names)
      get_filename_component(source ${name} ABSOLUTE BASE_DIR ${folder})
      list(APPEND sources ${source})
    endforeach()
  endforeach()
  add_library(gw_cpu_kernels_${level} SHARED ${sources})
  target_compile_definitions(gw_cpu_kernels_${level} PRIVATE GW_DEVICE=cpu)
  target_compile_options(gw_cpu_kernels_${level} PRIVATE -march=${level})
  gw_place_kernels(gw_cpu_kernels_${level} /glibc-hwcaps/${level})
endforeach()

# A target that links gw_sim gets the static kernels, unless it has the property GW_SHARED_KERNELS.
get_target_property(links gw_sim INTERFACE_LINK_LIBRARIES)
list(REMOVE_ITEM links gw_sim_cpu)
set(shared $<BOOL:$<TARGET_PROPERTY:GW_SHARED_KERNELS>>)
list(APPEND links $<$<NOT:${shared}>:gw_sim_cpu> $<${shared}:gw_cpu_kernels> $<${shared}:gw_gpu_host>)
set_target_properties(gw_sim PROPERTIES INTERFACE_LINK_LIBRARIES "${links}")

add_executable(gpuwars_packaged ${PROJECT_SOURCE_DIR}/game/main.cpp)
target_link_libraries(gpuwars_packaged PRIVATE gw_program)
file(RELATIVE_PATH to_kernels ${gw_packaged}/${CMAKE_INSTALL_BINDIR} ${gw_packaged}/${gw_kernel_folder})
set_target_properties(gpuwars_packaged PROPERTIES OUTPUT_NAME gpuwars GW_SHARED_KERNELS ON
  RUNTIME_OUTPUT_DIRECTORY ${gw_packaged}/${CMAKE_INSTALL_BINDIR}
  INSTALL_RPATH "$ORIGIN/${to_kernels}" BUILD_WITH_INSTALL_RPATH ON)
foreach(level IN LISTS gw_kernel_levels)
  add_dependencies(gpuwars_packaged gw_cpu_kernels_${level})
endforeach()
install(TARGETS gpuwars_packaged RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT game)
