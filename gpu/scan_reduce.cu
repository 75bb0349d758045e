#include "gpu/scan_reduce.h"

namespace gw::GW_DEVICE {
namespace {

// Exclusive scan of s.word[0 .. kLanes) in place, by all lanes of a team; s.total is the sum. Doubling
// (Hillis and Steele 1986) on cuda; a plain loop on cpu, where a phase is a loop anyway.
template <uint32_t kLanes>
struct ScanShared {
  uint64_t word[2][kLanes];
  uint64_t total;
};

template <uint32_t kLanes, class Team>
GW_BODY const uint64_t* scanShared(const Team& team, ScanShared<kLanes>& s) {
#if GW_ON_CUDA
  uint32_t from = 0;
  for (uint32_t step = 1; step < kLanes; step *= 2) {
    team.phase([&](uint32_t lane) {
      s.word[1 - from][lane] = s.word[from][lane] + (lane >= step ? s.word[from][lane - step] : 0);
    });
    from = 1 - from;
  }
  team.phase([&](uint32_t lane) {
    s.word[1 - from][lane] = lane ? s.word[from][lane - 1] : 0;
    if (lane == kLanes - 1) s.total = s.word[from][lane];
  });
  return s.word[1 - from];
#else
  (void)team;
  uint64_t sum = 0;
  for (uint32_t lane = 0; lane < kLanes; ++lane) {
    s.word[1][lane] = sum;
    sum += s.word[0][lane];
  }
  s.total = sum;
  return s.word[1];
#endif
}

constexpr uint32_t kBlockLanes = 256, kPerLane = kScanBlock / kBlockLanes;

// One team: one block of kScanBlock items.
struct ScanWithinBlocks {
  static constexpr uint32_t kLanes = kBlockLanes;
  using Shared = ScanShared<kLanes>;
  uint64_t* within;  // null: only the sums are wanted
  uint64_t* sums;
  const uint64_t* in;
  uint32_t count;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    const uint32_t begin = team.index * kScanBlock;
    team.phase([&](uint32_t lane) {
      uint64_t sum = 0;
      for (uint32_t k = 0; k < kPerLane; ++k) {
        const uint32_t i = begin + lane * kPerLane + k;
        if (i < count) sum += in[i];
      }
      s.word[0][lane] = sum;
    });
    const uint64_t* before = scanShared<kLanes>(team, s);
    team.phase([&](uint32_t lane) {
      uint64_t sum = before[lane];
      for (uint32_t k = 0; k < kPerLane && within; ++k) {
        const uint32_t i = begin + lane * kPerLane + k;
        if (i >= count) break;
        within[i] = sum;
        sum += in[i];
      }
      if (lane == 0) sums[team.index] = s.total;
    });
  }
};

// One team in all: turns the blocks' sums into what stands before each block, and their total.
struct ScanBlockSums {
  static constexpr uint32_t kLanes = 256;
  using Shared = ScanShared<kLanes>;
  uint64_t* sums;   // [blocks + 1], in place; null entries are not expected
  uint64_t* total;  // may be null
  uint32_t blocks;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    const uint32_t each = (blocks + kLanes - 1) / kLanes;
    team.phase([&](uint32_t lane) {
      uint64_t sum = 0;
      for (uint32_t b = lane * each; b < (lane + 1) * each && b < blocks; ++b) sum += sums[b];
      s.word[0][lane] = sum;
    });
    const uint64_t* before = scanShared<kLanes>(team, s);
    team.phase([&](uint32_t lane) {
      uint64_t sum = before[lane];
      for (uint32_t b = lane * each; b < (lane + 1) * each && b < blocks; ++b) {
        const uint64_t own = sums[b];
        sums[b] = sum;
        sum += own;
      }
      if (lane == 0) {
        sums[blocks] = s.total;
        if (total) *total = s.total;
      }
    });
  }
};

}  // namespace

Scan::Scan(Queue& queue, uint32_t count)
    : count_(count), within_(queue, count), beforeBlock_(queue, scanBlocks(count) + 1) {}

ScanView Scan::view() const {
  return {within_.data(), beforeBlock_.data(), scanBlocks(count_)};
}

void Scan::run(Queue& queue, const uint64_t* d_in) {
  const uint32_t blocks = scanBlocks(count_);
  forEachTeam(queue, blocks, ScanWithinBlocks{within_.data(), beforeBlock_.data(), d_in, count_});
  forEachTeam(queue, 1, ScanBlockSums{beforeBlock_.data(), nullptr, blocks});
}

Reduce::Reduce(Queue& queue, uint32_t count) : count_(count), sums_(queue, scanBlocks(count) + 1) {}

void Reduce::run(Queue& queue, const uint64_t* d_in, uint64_t* d_sum) {
  const uint32_t blocks = scanBlocks(count_);
  forEachTeam(queue, blocks, ScanWithinBlocks{nullptr, sums_.data(), d_in, count_});
  forEachTeam(queue, 1, ScanBlockSums{sums_.data(), d_sum, blocks});
}

}  // namespace gw::GW_DEVICE
