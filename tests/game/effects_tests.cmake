# Effects: what follows from reports needs nothing; what draws needs OpenGL.
add_executable(game_effects_test effects_test.cpp)
target_link_libraries(game_effects_test PRIVATE gw_effects gw_ui GTest::gtest_main)
gtest_discover_tests(game_effects_test)

add_executable(world_view_gl_test world_view_gl_test.cpp)
target_compile_definitions(world_view_gl_test PRIVATE GW_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(world_view_gl_test PRIVATE gw_view gw_tables GTest::gtest_main)
gtest_discover_tests(world_view_gl_test)
