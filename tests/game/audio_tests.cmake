# Sound: what starts, what it sounds like through OpenAL's loopback device, and what damaged files cost. Needs no
# sound card.
add_executable(audio_test
  audio_facade_test.cpp
  audio_files_test.cpp
  audio_listener.cpp
  audio_mix_test.cpp
  audio_music_test.cpp
  audio_voices_test.cpp)
target_include_directories(audio_test SYSTEM PRIVATE ${GW_RAPIDCHECK_INCLUDE_DIR})
target_compile_definitions(audio_test PRIVATE GW_ASSETS_DIR="${PROJECT_SOURCE_DIR}/assets")
target_link_libraries(audio_test PRIVATE gw_audio gw_tables ${GW_RAPIDCHECK_LIBRARY} GTest::gtest_main)
gtest_discover_tests(audio_test PROPERTIES ENVIRONMENT RC_PARAMS=seed=2013)
