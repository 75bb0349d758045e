# `cmake --install BUILD --component gpu`: gpu/ as the CMake package gpuwars and for pkg-config, and nothing of the game.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(gw_package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/gpuwars)

set(gw_installed gw_gpu_flags gw_gpu_host gw_gpu_cpu)
if(GW_HAVE_CUDA)
  list(APPEND gw_installed gw_gpu_cuda)
endif()
foreach(target IN LISTS gw_installed)
  string(REPLACE gw_ "" exported ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${exported})
endforeach()
install(TARGETS ${gw_installed} EXPORT gpuwarsTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT gpu)
install(EXPORT gpuwarsTargets NAMESPACE gpuwars:: DESTINATION ${gw_package_folder} COMPONENT gpu)
install(FILES ${gw_public_headers} DESTINATION include/gpuwars COMPONENT gpu)
install(FILES ${gw_detail_headers} DESTINATION include/gpuwars/detail COMPONENT gpu)

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/gpuwarsConfig.cmake.in
  ${PROJECT_BINARY_DIR}/package/gpuwarsConfig.cmake INSTALL_DESTINATION ${gw_package_folder})
# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/gpuwarsConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/gpuwarsConfig.cmake ${PROJECT_BINARY_DIR}/package/gpuwarsConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/cmake/cuda_host_compiler.cmake ${PROJECT_SOURCE_DIR}/cmake/cuda_language.cmake
  ${PROJECT_SOURCE_DIR}/cmake/cuda_math.h ${PROJECT_SOURCE_DIR}/cmake/gw_add_kernels.cmake
  DESTINATION ${gw_package_folder} COMPONENT gpu)

# For builds without CMake. The prefix is found from where the file lies, so that the folder may be moved.
set(gw_pc_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
if(IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR})
  set(gw_pc_prefix ${CMAKE_INSTALL_PREFIX})
  set(gw_pc_libdir ${CMAKE_INSTALL_LIBDIR})
else()
  file(RELATIVE_PATH gw_pc_up /prefix/${gw_pc_folder} /prefix)
  set(gw_pc_prefix \${pcfiledir}/${gw_pc_up})
  set(gw_pc_libdir \${prefix}/${CMAKE_INSTALL_LIBDIR})
endif()
list(JOIN gw_exact_flags " " gw_pc_flags)
list(JOIN gw_sanitize_flags " " gw_pc_sanitize)
set(gw_pc_runtime "")
if(GW_HAVE_CUDA) # the library asks the CUDA runtime for devices
  set(gw_pc_runtime "-L${CUDAToolkit_LIBRARY_DIR} -lcudart_static -ldl -lrt")
endif()
configure_file(${PROJECT_SOURCE_DIR}/cmake/gpuwars.pc.in ${PROJECT_BINARY_DIR}/package/gpuwars.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/gpuwars.pc DESTINATION ${gw_pc_folder} COMPONENT gpu)
