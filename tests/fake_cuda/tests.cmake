# Tests that the stand-in makes possible. Included by tests/CMakeLists.txt when it is on.
add_executable(fault_test ${CMAKE_CURRENT_LIST_DIR}/fault_test.cpp)
target_include_directories(fault_test PRIVATE ${CMAKE_CURRENT_LIST_DIR})
target_compile_definitions(fault_test PRIVATE GW_FAULT_TABLE="${CMAKE_CURRENT_BINARY_DIR}/cuda_faults.md" GW_FAULT_DOCS="${PROJECT_SOURCE_DIR}/docs/reference/cuda-faults.md")
target_link_libraries(fault_test PRIVATE gw_program ${GW_CUDART} GTest::gtest_main)
gw_uses(fault_test ASSETS)
add_test(NAME fault_test COMMAND fault_test)
set_tests_properties(fault_test PROPERTIES LABELS cuda COST 60) # begun first, since it takes longest

# A recorded run on both devices at once, tick by tick.
add_test(NAME verify_against_cuda
  COMMAND gpuwars verify --device cpu --against cuda first_seconds.gwr
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/replays)
set_tests_properties(verify_against_cuda PROPERTIES LABELS cuda TIMEOUT 600)
