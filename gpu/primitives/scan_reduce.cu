#include <gpuwars/scan_reduce.h>

namespace gw::GW_DEVICE {
namespace {

// The word of item i of an array.
struct WordAt {
  const uint64_t* words;
  GW_BODY uint64_t operator()(uint32_t i) const { return words[i]; }
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
  run(queue, WordAt{d_in});
}

void Scan::sumBlocks(Queue& queue) {
  forEachTeam(queue, 1, ScanBlockSums{beforeBlock_.data(), nullptr, scanBlocks(count_)});
}

Reduce::Reduce(Queue& queue, uint32_t count) : count_(count), sums_(queue, scanBlocks(count) + 1) {}

void Reduce::run(Queue& queue, const uint64_t* d_in, uint64_t* d_sum) {
  const uint32_t blocks = scanBlocks(count_);
  forEachTeam(queue, blocks, ScanWithinBlocks<WordAt>{nullptr, sums_.data(), {d_in}, count_});
  forEachTeam(queue, 1, ScanBlockSums{sums_.data(), d_sum, blocks});
}

}  // namespace gw::GW_DEVICE
