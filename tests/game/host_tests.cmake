# Tables, replays and the command line: host code, needs nothing.
set(here ${CMAKE_CURRENT_LIST_DIR})
add_executable(game_host_test
  ${here}/command_line_test.cpp
  ${here}/replay_allocation_watch.cpp
  ${here}/replay_bomb_test.cpp
  ${here}/replay_damage_test.cpp
  ${here}/replay_diff_test.cpp
  ${here}/replay_files_test.cpp
  ${here}/replay_formats_test.cpp
  ${here}/replay_partial_test.cpp
  ${here}/replay_recorder_test.cpp
  ${here}/replay_samples.cpp
  ${here}/replay_test.cpp
  ${here}/tables_damage_test.cpp
  ${here}/tables_test.cpp
  ${here}/toml_library_test.cpp)
target_include_directories(game_host_test SYSTEM PRIVATE ${GW_RAPIDCHECK_INCLUDE_DIR})
target_compile_definitions(game_host_test PRIVATE GW_ASSETS_DIR="${here}/../../assets" GW_TEST_DATA_DIR="${here}/../data")
target_link_libraries(game_host_test PRIVATE gw_command_line gw_replay gw_tables gw_toml gw_fmt ${GW_RAPIDCHECK_LIBRARY}
  GTest::gtest_main)
gtest_discover_tests(game_host_test)

add_executable(game_files_test ${here}/files_test.cpp ${here}/locale_test.cpp)
target_link_libraries(game_files_test PRIVATE gw_platform gw_ui gw_profile_figures GTest::gtest_main)
gtest_discover_tests(game_files_test)

add_executable(failover_test ${here}/failover_test.cpp)
target_compile_definitions(failover_test PRIVATE GW_ASSETS_DIR="${here}/../../assets")
target_link_libraries(failover_test PRIVATE gw_program GTest::gtest_main)
gtest_discover_tests(failover_test)

add_executable(desync_test ${here}/desync/desync_finder_test.cpp)
target_compile_definitions(desync_test PRIVATE GW_ASSETS_DIR="${here}/../../assets")
target_link_libraries(desync_test PRIVATE gw_desync gw_tables GTest::gtest_main)
gtest_discover_tests(desync_test)
