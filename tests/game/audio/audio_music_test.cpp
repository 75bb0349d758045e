// How the music follows the frame budget and the screens.
#include <gtest/gtest.h>

#include "game/audio/music.h"
#include "tests/game/audio/audio_listener.h"

namespace gw::test {
namespace {

// Over ten seconds: the share of ticks in which the music drops out, and how deep.
struct Dropped {
  float share = 0, deepest = 1;
};

Dropped droppedAt(uint32_t frameTime_us) {
  Dropped dropped;
  for (uint32_t tick = 1; tick <= 600; ++tick) {
    const Stutter now = stutter(tick, frameTime_us, gameRules());
    EXPECT_GT(now.gain, 0);
    EXPECT_LE(now.gain, 1);
    EXPECT_GE(now.pitch, 0.95f);
    EXPECT_LE(now.pitch, 1);
    dropped.share += (now.gain < 1) / 600.0f;
    dropped.deepest = std::min(dropped.deepest, now.gain);
  }
  return dropped;
}

TEST(Stutter, IsNoneWhileThereIsTime) {
  for (const uint32_t us : {0u, 16667u, 25000u, 33000u}) EXPECT_EQ(droppedAt(us).share, 0) << us;
  EXPECT_EQ(stutter(1, 16667, gameRules()).pitch, 1);
}

TEST(Stutter, GrowsTowardsTheLimit) {
  const Dropped some = droppedAt(45000), more = droppedAt(65000), most = droppedAt(83333);
  EXPECT_GT(some.share, 0);
  EXPECT_GT(more.share, some.share);
  EXPECT_GT(most.share, more.share);
  EXPECT_LT(most.share, 0.4f);  // still music
  EXPECT_LT(most.deepest, some.deepest);
  EXPECT_LT(stutter(1, 83333, gameRules()).pitch, stutter(1, 45000, gameRules()).pitch);
}

TEST(Stutter, StaysWithinBoundsForAnyBudget) {
  EXPECT_EQ(droppedAt(0xffffffff).share, droppedAt(83333).share);
  Rules rules = gameRules();
  rules.budget.start_us = rules.budget.limit_us;
  for (uint32_t tick = 0; tick < 100; ++tick) EXPECT_GT(stutter(tick, rules.budget.limit_us, rules).gain, 0);
}

TEST(Scenes, ScreensAreQuieterThanPlay) {
  EXPECT_EQ(musicLevel(Scene::play), 1);
  EXPECT_EQ(effectsLevel(Scene::play), 1);
  EXPECT_LT(musicLevel(Scene::pause), musicLevel(Scene::over));
  EXPECT_LT(musicLevel(Scene::over), 1);
  EXPECT_LT(effectsLevel(Scene::title), 0.5f);
  EXPECT_GT(effectsLevel(Scene::title), 0);
}

}  // namespace
}  // namespace gw::test
