// The part of a scan that one team does. Not for users: include <gpuwars/scan_reduce.h>.
#pragma once

#include <gpuwars/exec.h>

namespace gw::GW_DEVICE {

inline constexpr uint32_t kScanBlock = 1024;

GW_FN uint32_t scanBlocks(uint32_t count) {
  return (count + kScanBlock - 1) / kScanBlock;
}

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

// One team: one block of kScanBlock items.
template <class Source>
struct ScanWithinBlocks {
  static constexpr uint32_t kLanes = 256, kPerLane = kScanBlock / kLanes;
  using Shared = ScanShared<kLanes>;
  uint64_t* within;  // null: only the sums are wanted
  uint64_t* sums;
  Source source;
  uint32_t count;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    const uint32_t begin = team.index * kScanBlock;
    team.phase([&](uint32_t lane) {
      uint64_t sum = 0;
      for (uint32_t k = 0; k < kPerLane; ++k) {
        const uint32_t i = begin + lane * kPerLane + k;
        if (i >= count) break;
        const uint64_t own = source(i);
        if (within) within[i] = own;
        sum += own;
      }
      s.word[0][lane] = sum;
    });
    const uint64_t* before = scanShared<kLanes>(team, s);
    team.phase([&](uint32_t lane) {
      uint64_t sum = before[lane];
      for (uint32_t k = 0; k < kPerLane && within; ++k) {
        const uint32_t i = begin + lane * kPerLane + k;
        if (i >= count) break;
        const uint64_t own = within[i];
        within[i] = sum;
        sum += own;
      }
      if (lane == 0) sums[team.index] = s.total;
    });
  }
};

}  // namespace gw::GW_DEVICE
