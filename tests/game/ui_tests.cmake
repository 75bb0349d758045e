# Camera, pacing, input and screens: everything about the window that needs no window.
add_executable(game_pacing_test camera_test.cpp loop_pacer_test.cpp)
target_link_libraries(game_pacing_test PRIVATE gw_pacing GTest::gtest_main)
gtest_discover_tests(game_pacing_test)

if(GW_WINDOW)
  add_executable(game_input_test input_test.cpp)
  target_link_libraries(game_input_test PRIVATE gw_input GTest::gtest_main)
  gtest_discover_tests(game_input_test)
endif()

add_executable(game_ui_test ui_test.cpp ui_font_test.cpp)
target_compile_definitions(game_ui_test PRIVATE GW_SOURCE_ASSETS="${PROJECT_SOURCE_DIR}/assets")
target_link_libraries(game_ui_test PRIVATE gw_ui GTest::gtest_main)
gtest_discover_tests(game_ui_test)
