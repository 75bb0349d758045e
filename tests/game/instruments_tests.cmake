# The pure part of the game's instruments.
add_executable(game_instruments_test instruments_test.cpp)
target_compile_definitions(game_instruments_test PRIVATE GW_ASSETS_DIR="${PROJECT_SOURCE_DIR}/assets")
target_link_libraries(game_instruments_test PRIVATE gw_instruments gw_tables GTest::gtest_main)
gtest_discover_tests(game_instruments_test)
