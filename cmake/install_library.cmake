# `cmake --install BUILD --component gpu`: gpu/ as the CMake package gpuwars, and nothing of the game.
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
install(DIRECTORY ${PROJECT_SOURCE_DIR}/gpu DESTINATION include COMPONENT gpu FILES_MATCHING PATTERN "*.h")

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/gpuwarsConfig.cmake.in
  ${PROJECT_BINARY_DIR}/package/gpuwarsConfig.cmake INSTALL_DESTINATION ${gw_package_folder})
# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/gpuwarsConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/gpuwarsConfig.cmake ${PROJECT_BINARY_DIR}/package/gpuwarsConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/cmake/cuda_language.cmake ${PROJECT_SOURCE_DIR}/cmake/gw_add_kernels.cmake
  DESTINATION ${gw_package_folder} COMPONENT gpu)
