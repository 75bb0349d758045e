# Camera, pacing, input and screens: everything about the window that needs no window.
add_executable(game_pacing_test camera_test.cpp frame_limiter_test.cpp loop_pacer_test.cpp practice_test.cpp)
target_link_libraries(game_pacing_test PRIVATE gw_pacing gw_view GTest::gtest_main)
gtest_discover_tests(game_pacing_test)

if(GW_WINDOW)
  add_executable(game_input_test frame_events_test.cpp gamepad_test.cpp input_test.cpp key_labels_test.cpp
    pad_virtual_test.cpp player_input_test.cpp)
  target_include_directories(game_input_test SYSTEM PRIVATE ${GW_RAPIDCHECK_INCLUDE_DIR})
  target_link_libraries(game_input_test PRIVATE gw_input ${GW_RAPIDCHECK_LIBRARY} GTest::gtest_main)
  gtest_discover_tests(game_input_test)
endif()

add_executable(game_ui_test ui_modes_test.cpp ui_test.cpp ui_font_test.cpp)
target_compile_definitions(game_ui_test PRIVATE gw_screen_flow GW_SOURCE_ASSETS="${PROJECT_SOURCE_DIR}/assets")
target_link_libraries(game_ui_test PRIVATE gw_screen_flow gw_ui GTest::gtest_main)
gtest_discover_tests(game_ui_test)

if(GW_WINDOW)
  add_executable(game_settings_test settings_edit_test.cpp settings_file_test.cpp settings_menu_test.cpp settings_screen_test.cpp
    settings_text_test.cpp)
  target_include_directories(game_settings_test SYSTEM PRIVATE ${GW_RAPIDCHECK_INCLUDE_DIR})
  target_link_libraries(game_settings_test PRIVATE gw_settings_screen ${GW_RAPIDCHECK_LIBRARY} GTest::gtest_main)
  gtest_discover_tests(game_settings_test)
endif()
