#include "gpu/exec/worker_pool.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>

#include "gpu/devices/processors.h"
#include "gpu/exec/float_state.h"
#include "tests/gpu/exec/float_bits.h"

namespace gw {
namespace {

struct Visits {
  std::vector<std::atomic<uint32_t>> of;
  explicit Visits(uint32_t chunks) : of(chunks) {}
  static void run(const void* context, uint32_t chunk) {
    ++const_cast<Visits*>(static_cast<const Visits*>(context))->of[chunk];
  }
  uint32_t wrong(uint32_t expected) const {
    uint32_t count = 0;
    for (const auto& visits : of) count += visits != expected;
    return count;
  }
};

TEST(WorkerPool, RunsEachChunkOnce) {
  for (uint32_t threads : {1u, 2u, 3u, 7u, 16u}) {
    WorkerPool pool(threads);
    for (uint32_t chunks : {0u, 1u, 2u, 5u, 1000u}) {
      Visits visits(chunks);
      pool.run(chunks, Visits::run, &visits);
      EXPECT_EQ(visits.wrong(1), 0u) << threads << " threads, " << chunks << " chunks";
    }
  }
}

TEST(WorkerPool, SurvivesManySmallRuns) {
  WorkerPool pool(4);
  uint64_t expected[8] = {};
  Visits visits(8);
  for (uint32_t run = 0; run < 20000; ++run) {
    const uint32_t chunks = run % 8 + 1;
    for (uint32_t c = 0; c < chunks; ++c) ++expected[c];
    pool.run(chunks, Visits::run, &visits);
    // When run() returns all of it is done, not only claimed.
    for (uint32_t c = 0; c < 8; ++c) ASSERT_EQ(visits.of[c], expected[c]) << "run " << run;
  }
}

TEST(WorkerPool, WakesUpAfterPark) {
  WorkerPool pool(3);
  Visits visits(64);
  for (uint32_t round = 1; round <= 50; ++round) {
    pool.run(64, Visits::run, &visits);
    pool.park();
    if (round % 10 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ASSERT_EQ(visits.wrong(round), 0u);
  }
}

TEST(WorkerPool, IsDestroyedUnusedIdleOrParked) {
  for (int i = 0; i < 200; ++i) {
    auto pool = std::make_unique<WorkerPool>(3);
    Visits visits(16);
    if (i % 3 > 0) pool->run(16, Visits::run, &visits);
    if (i % 3 > 1) pool->park();
    if (i % 20 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    pool.reset();
    ASSERT_EQ(visits.wrong(i % 3 > 0), 0u);
  }
}

TEST(WorkerPool, HasAtLeastOneThreadAndAtMost256) {
  EXPECT_EQ(WorkerPool(0).threads(), std::min(256u, readProcessors().usable()));
  EXPECT_EQ(WorkerPool(1).threads(), 1u);
  EXPECT_EQ(WorkerPool(5).threads(), 5u);
  EXPECT_EQ(WorkerPool(100000).threads(), 256u);
}

// A driver or a library may leave any thread that it touches in another state.
TEST(WorkerPool, EveryRunStartsWithTheDefaultFloatState) {
  using test::FloatBits;
  for (uint32_t threads : {1u, 4u}) {
    WorkerPool pool(threads);
    for (int round = 0; round < 100; ++round) {
      pool.run(
          8, [](const void*, uint32_t) { test::addFloatBits(FloatBits::flush); }, nullptr);
      test::addFloatBits(FloatBits::up);
      std::atomic<uint32_t> dirty{0};
      pool.run(
          8,
          [](const void* context, uint32_t) {
            auto& dirty = *const_cast<std::atomic<uint32_t>*>(static_cast<const std::atomic<uint32_t>*>(context));
            if (test::flushesSubnormals() || !floatStateIsDefault()) ++dirty;
          },
          &dirty);
      ASSERT_EQ(dirty, 0u) << threads << " threads, round " << round;
    }
  }
  EXPECT_TRUE(floatStateIsDefault());
}

}  // namespace
}  // namespace gw
