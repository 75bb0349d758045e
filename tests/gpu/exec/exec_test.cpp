// forEach and forEachTeam: every item once, phases in order, whatever the order of visits.
#include "gpu/exec/exec.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "tests/gpu/probes.h"
#include "tests/gpu/random_cells.h"
#include "tests/reference/gpu_oracles.h"

namespace gw::test {
namespace {

const Probes kDevice = cpu::probes();

constexpr uint32_t kCounts[] = {0, 1, 2, 255, 256, 257, 1000, 100000};

std::vector<uint32_t> visitedOnce(uint32_t count, uint32_t all) {
  std::vector<uint32_t> visits(all, 0);
  std::fill(visits.begin(), visits.begin() + count, 1);
  return visits;
}

TEST(ForEach, VisitsEveryItemExactlyOnce) {
  for (uint32_t count : kCounts) {
    for (uint32_t threads : {1u, 2u, 7u}) {
      EXPECT_EQ(kDevice.countVisits({threads}, count, nullptr), visitedOnce(count, count + 1024)) << count;
    }
  }
}

TEST(ForEach, StopsAtTheLiveCount) {
  for (uint32_t capacity : kCounts) {
    for (uint32_t live : {0u, 1u, 200u, 256u, 4000u}) {
      const auto expected = visitedOnce(std::min(live, capacity), capacity + 1024);
      EXPECT_EQ(kDevice.countVisits({2}, capacity, &live), expected) << live << " of " << capacity;
    }
  }
}

TEST(ForEach, NeverPassesTheCapacityWhateverTheLiveCountSays) {
  for (uint32_t live : {1001u, 5000u, 0xFFFFFFFFu}) {
    EXPECT_EQ(kDevice.countVisits({2}, 1000, &live), visitedOnce(1000, 2024)) << live;
  }
}

TEST(VisitOrderTest, EachOrderIsAPermutation) {
  for (VisitOrder order : {VisitOrder::forward, VisitOrder::reversed, VisitOrder::shuffled}) {
    for (uint32_t n = 1; n < 600; ++n) {
      std::set<uint32_t> seen;
      for (uint32_t i = 0; i < n; ++i) seen.insert(cpu::visit(order, i, n));
      ASSERT_EQ(seen.size(), n);
      ASSERT_EQ(*seen.rbegin(), n - 1);
    }
  }
}

TEST(VisitOrderTest, OrdersDifferFromForward) {
  for (VisitOrder order : {VisitOrder::reversed, VisitOrder::shuffled}) {
    for (uint32_t n : {3u, 64u, 128u, 256u, 257u, 1000u}) {
      uint32_t moved = 0;
      for (uint32_t i = 0; i < n; ++i) moved += cpu::visit(order, i, n) != i;
      EXPECT_GT(moved, n / 2) << n;
    }
  }
}

TEST(ForEachTeam, RunsItsPhasesInOrder) {
  for (size_t teams : {0, 1, 2, 7, 300}) {
    const Words lines = makeWords(teams * 128, teams);
    for (uint32_t threads : {1u, 2u, 7u}) {
      EXPECT_EQ(kDevice.foldLines({threads}, lines), naive::foldLines(lines)) << teams << " teams";
    }
  }
}

TEST(ForEachTeam, HasSharedMemoryBeyond48KiB) {
  std::vector<uint32_t> line(16384);
  std::iota(line.begin(), line.end(), 5u);
  auto expected = line;
  std::reverse(expected.begin(), expected.end());
  EXPECT_EQ(kDevice.reverseBigLine({2}, line), expected);
}

TEST(Atomics, TotalsAreThoseOfALoop) {
  const Words words = makeWords(100000, 9);
  uint32_t sum = 0;
  for (uint64_t word : words) sum += uint32_t(word);
  const Words expected{sum, *std::max_element(words.begin(), words.end()),
                       std::accumulate(words.begin(), words.end(), uint64_t(0))};
  for (uint32_t threads : {1u, 2u, 7u}) EXPECT_EQ(kDevice.atomics({threads}, words), expected);
}

}  // namespace
}  // namespace gw::test
