# Tests of the PTX machine's parts, which need no nvcc, and with GW_PTX_MACHINE of the runtime with kernels that nvcc
# compiled. What the machine is for, games and primitives on it, tests/ptx_machine/run runs. Included by tests/CMakeLists.txt.
set(gw_ptx_folder ${CMAKE_CURRENT_LIST_DIR})
add_test(NAME ptx_machine_plan COMMAND ${Python3_EXECUTABLE} -B ${gw_ptx_folder}/run_plan_test.py)

if(GW_PTX_MACHINE)
  add_library(gw_ptx_test_kernels STATIC ${gw_ptx_folder}/runtime/test_kernels.cu)
  set_target_properties(gw_ptx_test_kernels PROPERTIES CUDA_STANDARD 20 CUDA_STANDARD_REQUIRED ON CUDA_EXTENSIONS OFF)
  gw_know_cuda20()
  gw_for_ptx_machine(gw_ptx_test_kernels)
  target_link_libraries(gw_ptx_test_kernels PUBLIC gw_options ${GW_CUDART})

  add_executable(ptx_runtime_test ${gw_ptx_folder}/runtime/runtime_test.cpp ${gw_ptx_folder}/runtime/machine_options_test.cpp)
  target_link_libraries(ptx_runtime_test PRIVATE gw_ptx_test_kernels GTest::gtest_main)
  gtest_discover_tests(ptx_runtime_test DISCOVERY_TIMEOUT 60 PROPERTIES LABELS ptx)
endif()
