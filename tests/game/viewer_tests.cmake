# Watching replays: going to any tick, and the films of them.
add_executable(game_viewer_test viewer_film_test.cpp viewer_moments_test.cpp viewer_samples.cpp viewer_screen_test.cpp
  viewer_seek_test.cpp)
target_compile_definitions(game_viewer_test PRIVATE GW_ASSETS_DIR="${PROJECT_SOURCE_DIR}/assets")
target_link_libraries(game_viewer_test PRIVATE gw_video gw_viewer gw_tables GTest::gtest_main)
gtest_discover_tests(game_viewer_test)
if(GW_WINDOW)
  add_executable(game_viewer_keys_test viewer_keys_test.cpp)
  target_link_libraries(game_viewer_keys_test PRIVATE gw_viewer_keys GTest::gtest_main)
  gtest_discover_tests(game_viewer_keys_test)
endif()
