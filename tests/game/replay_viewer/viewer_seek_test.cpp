// Any tick that is gone to is the one that plain playing gives: hash, report, effects and sparks.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "game/replay_viewer/replay_viewer.h"
#include "viewer_samples.h"

namespace gw::test {
namespace {

void goTo(ReplayViewer& viewer, uint32_t tick) {
  viewer.seek(tick);
  while (!viewer.continueSeek(50)) {
  }
}

// The ones that are still to be seen.
std::vector<Particle> alive(std::vector<Particle> sparks, uint32_t tick) {
  std::erase_if(sparks, [&](const Particle& p) { return tick - p.birthTick > p.life_ticks; });
  return sparks;
}

bool same(const Particle& a, const Particle& b) {
  return a.x == b.x && a.y == b.y && a.velocity_x == b.velocity_x && a.velocity_y == b.velocity_y &&
         a.birthTick == b.birthTick && a.life_ticks == b.life_ticks && a.colour == b.colour;
}

void expectAt(ReplayViewer& viewer, const ViewerSample& sample, uint32_t tick) {
  ASSERT_EQ(viewer.tick(), tick);
  const RunMonitor &shown = viewer.run().monitor(), &plain = sample.monitors[tick];
  EXPECT_EQ(shown.last().hash, plain.last().hash) << tick;
  EXPECT_EQ(shown.last().score, plain.last().score) << tick;
  EXPECT_EQ(shown.last().ship_x, plain.last().ship_x) << tick;
  EXPECT_EQ(shown.last().over, plain.last().over) << tick;
  EXPECT_EQ(shown.dataPerSecond(), plain.dataPerSecond()) << tick;
  EXPECT_EQ(shown.trailingFrameTime_us(), plain.trailingFrameTime_us()) << tick;
  EXPECT_EQ(shown.lastContact().tick, plain.lastContact().tick) << tick;
  const EffectTime time{tick, 0.5f};
  const RunEffects &effects = viewer.run().effects(), &wanted = sample.effects[tick];
  EXPECT_EQ(effects.shake().at(time, 1).x, wanted.shake().at(time, 1).x) << tick;
  EXPECT_EQ(effects.scorePops().at(time).size(), wanted.scorePops().at(time).size()) << tick;
  EXPECT_EQ(effects.gridBends().at(time).size(), wanted.gridBends().at(time).size()) << tick;
  const auto sparks = alive(viewer.run().simulation().particles(), tick), flew = alive(sample.flying[tick], tick);
  EXPECT_TRUE(std::equal(sparks.begin(), sparks.end(), flew.begin(), flew.end(), same))
      << "tick " << tick << ": " << sparks.size() << " sparks instead of " << flew.size();
}

void seekAtRandom(ReplayViewer& viewer, const ViewerSample& sample, uint32_t times) {
  std::mt19937 dice(7);
  for (uint32_t i = 0; i < times; ++i) {
    const uint32_t tick = dice() % (sample.replay.ticks() + 1);
    goTo(viewer, tick);
    expectAt(viewer, sample, tick);
    if (i % 4 != 0 || viewer.ended()) continue;
    viewer.playOne();  // and playing goes on from there
    expectAt(viewer, sample, tick + 1);
  }
  EXPECT_FALSE(viewer.differsFrom().has_value());
}

TEST(ViewerSeek, ReachesWhatPlainPlayingShowsWithAndWithoutPrefetching) {
  const ViewerSample sample = playedSample(700);
  ASSERT_EQ(sample.replay.ticks(), 700u);
  ASSERT_GT(sample.flying[300].size(), 0u) << "the sample has sparks";
  ReplayViewer alone(sample.replay, sample.simulation(), nullptr);
  seekAtRandom(alone, sample, 24);
  ReplayViewer prefetching(sample.replay, sample.simulation(), [&] { return sample.simulation(); });
  seekAtRandom(prefetching, sample, 24);
}

TEST(ViewerSeek, ReachesTheSameWhereTheArrangementIsState) {
  const ViewerSample sample = playedSample(500, 96, Gather::adaptive);
  ReplayViewer viewer(sample.replay, sample.simulation(), [&] { return sample.simulation(); });
  seekAtRandom(viewer, sample, 24);
}

TEST(ViewerSeek, GoesToTheEndAndBackFromIt) {
  const ViewerSample sample = playedSample(20000, 12);
  ASSERT_TRUE(sample.replay.result.over);
  const uint32_t end = sample.replay.ticks();
  ReplayViewer viewer(sample.replay, sample.simulation(), nullptr);
  goTo(viewer, UINT32_MAX);
  EXPECT_TRUE(viewer.ended());
  expectAt(viewer, sample, end);
  goTo(viewer, end - 1);
  EXPECT_FALSE(viewer.ended());
  expectAt(viewer, sample, end - 1);
  viewer.playOne();
  EXPECT_TRUE(viewer.ended());
  expectAt(viewer, sample, end);
  goTo(viewer, 0);
  expectAt(viewer, sample, 0);
  seekAtRandom(viewer, sample, 20);
}

TEST(ViewerSeek, ReachesTheSameWhenMemoryIsShort) {
  const ViewerSample sample = playedSample(1500);
  ReplayViewer viewer(
      sample.replay, sample.simulation(), [&] { return sample.simulation(); }, 60'000);
  goTo(viewer, 1500);
  EXPECT_LE(viewer.cache().bytes(), 60'000u);
  EXPECT_GT(viewer.cache().spacing().ticks, 240u);
  seekAtRandom(viewer, sample, 15);
}

TEST(ViewerSeek, TakesStepsBackAndTheLastSeekOfSeveral) {
  const ViewerSample sample = playedSample(400);
  ReplayViewer viewer(sample.replay, sample.simulation(), nullptr);
  goTo(viewer, 350);
  viewer.seekBy(-1);
  viewer.seekBy(-1);
  viewer.seekBy(-1);
  EXPECT_EQ(viewer.seekTarget(), 347u);
  while (!viewer.continueSeek(5)) EXPECT_TRUE(viewer.seekProgress() >= 0 && viewer.seekProgress() <= 1);
  expectAt(viewer, sample, 347);
  viewer.seek(10);
  viewer.seekBy(-1000);
  while (!viewer.continueSeek(5)) {
  }
  expectAt(viewer, sample, 0);
}

TEST(ViewerSeek, WorksNoLongerThanAskedAndSaysHowFarItIs) {
  const ViewerSample sample = playedSample(700);
  ReplayViewer viewer(sample.replay, sample.simulation(), nullptr);
  viewer.seek(700);
  float share = 0;
  uint32_t calls = 0;
  for (; !viewer.continueSeek(0); ++calls) {  // the least there is: one tick
    EXPECT_GE(viewer.seekProgress(), share);
    share = viewer.seekProgress();
    EXPECT_TRUE(viewer.seeking());
  }
  EXPECT_EQ(calls + 1, 700u);
  EXPECT_GT(share, 0.99f);
}

TEST(ViewerSeek, NamesTheFirstTickThatDiffersWhereverItWasFoundFrom) {
  ViewerSample sample = playedSample(600);
  sample.replay.hashes[249] ^= 1;  // tick 250
  sample.replay.hashes[399] ^= 1;
  ReplayViewer viewer(sample.replay, sample.simulation(), nullptr);
  goTo(viewer, 249);
  EXPECT_FALSE(viewer.differsFrom().has_value());
  goTo(viewer, 500);
  EXPECT_EQ(viewer.differsFrom(), 250u);
  goTo(viewer, 20);
  EXPECT_EQ(viewer.differsFrom(), 250u);
  ReplayViewer prefetching(sample.replay, sample.simulation(), [&] { return sample.simulation(); });
  while (!prefetching.prefetched()) std::this_thread::yield();
  EXPECT_EQ(prefetching.differsFrom(), 250u) << "found ahead of the tick that is shown";
}

TEST(ViewerSeek, WorksWithoutAPrefetchThreadThatFails) {
  const ViewerSample sample = playedSample(200);
  ReplayViewer viewer(sample.replay, sample.simulation(),
                      []() -> std::unique_ptr<Simulation> { throw std::bad_alloc(); });
  goTo(viewer, 150);
  expectAt(viewer, sample, 150);
}

TEST(ViewerSeek, EndsWhileThePrefetchThreadStillRuns) {
  const ViewerSample sample = playedSample(600);
  for (int i = 0; i < 5; ++i) {
    ReplayViewer viewer(sample.replay, sample.simulation(), [&] { return sample.simulation(); });
    goTo(viewer, 30u * i);
  }
}

}  // namespace
}  // namespace gw::test
