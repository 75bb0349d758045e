// Sorting integer keys in the registers of a block. For the cuda device only.
//
// Bitonic merging (Batcher 1968) in the form in which every comparison puts the smaller key first: two runs are merged
// by comparing the first with the last, the second with the last but one ("flip"), and then by halves.
//
//   merge of two runs of 4   0  ─┬───────  ─┬───  ─┬─    Lane t holds places t * kEach to t * kEach + kEach - 1.
//                            1  ─┼─┬─────  ─┼─┬─  ─┴─    Comparisons within a lane cost no exchange, those within
//                            2  ─┼─┼─┬───  ─┴─┼─  ─┬─    a warp are shuffles, and only those beyond it go through
//                            3  ─┼─┼─┼─┬─  ───┴─  ─┴─    shared memory, with two barriers. Of the 55 steps that
//                            4  ─┼─┼─┼─┴─  ─┬───  ─┬─    1,024 keys take, four a lane, these are 19, 30 and 6.
//                            5  ─┼─┼─┴───  ─┼─┬─  ─┴─
//                            6  ─┼─┴─────  ─┴─┼─  ─┬─
//                            7  ─┴───────  ───┴─  ─┴─
//                                flip     halves
//
// Since keys only ever move towards their side, the largest key fills up a run of any length, and nothing else is
// needed for it.
#pragma once

#include <gpuwars/exec.h>

#include <cstdint>

#if GW_ON_CUDA

namespace gw::GW_DEVICE {

inline constexpr uint32_t kWarp = 32, kWholeWarp = 0xFFFFFFFFu;

// Keys are unsigned integers, all different but for the largest one, which pads. kLanes is the size of the block, a
// multiple of kWarp; kEach, at least 4, and kLanes are powers of two. O(log^2) steps.
template <class Key, uint32_t kLanes, uint32_t kEach>
class BlockSort {
  static constexpr uint32_t kAtOnce = 4;  // keys of a lane in shared memory: 32 KB of 64 bits for 1,024 lanes
  static_assert(kEach >= kAtOnce);

 public:
  struct Shared {
    Key key[kAtOnce][kLanes];
  };

  // Sorts each stretch of so many places (a power of two from kEach to kLanes * kEach). All lanes of the block call it;
  // it ends with shared memory free for other uses.
  GW_BODY static void run(Key (&key)[kEach], Shared& s, uint32_t stretch) {
    sortOwn(key);
    for (uint32_t lanes = 2; lanes * kEach <= stretch; lanes *= 2) {
      compare<true>(key, s, lanes - 1, lanes / 2);
      for (uint32_t apart = lanes / 4; apart > 0; apart /= 2) compare<false>(key, s, apart, apart);
      halve<kEach / 2>(key);
    }
  }

 private:
  GW_BODY static void order(Key& first, Key& second) {
    const Key a = first, b = second;
    first = b < a ? b : a;
    second = b < a ? a : b;
  }

  template <uint32_t kStep>
  GW_BODY static void halve(Key (&key)[kEach]) {
    if constexpr (kStep > 0) {
      for (uint32_t e = 0; e < kEach; ++e) {
        if (!(e & kStep)) order(key[e], key[e | kStep]);
      }
      halve<kStep / 2>(key);
    }
  }

  template <uint32_t kRun = 2>
  GW_BODY static void sortOwn(Key (&key)[kEach]) {
    if constexpr (kRun <= kEach) {
      for (uint32_t e = 0; e < kEach; ++e) {
        if (!(e & kRun / 2)) order(key[e], key[e ^ (kRun - 1)]);
      }
      halve<kRun / 4>(key);
      sortOwn<kRun * 2>(key);
    }
  }

  // With the lane whose number differs by `bits`, of which `half` says who takes the larger keys. Four keys at a time,
  // of which j and j ^ 2 are as far from either end, so that a flip stays among them.
  template <bool kFlip>
  GW_BODY static void compare(Key (&key)[kEach], Shared& s, uint32_t bits, uint32_t half) {
    const uint32_t lane = threadIdx.x;
    const bool takesLarger = lane & half;
    for (uint32_t begin = 0; begin < kEach / 2; begin += 2) {
      const auto mine = [&](uint32_t j) -> Key& { return key[j < 2 ? begin + j : kEach + 1 - begin - j]; };
      const auto from = [](uint32_t j) { return kFlip ? j ^ 2 : j; };
      Key other[kAtOnce];
      if (bits < kWarp) {
        for (uint32_t j = 0; j < kAtOnce; ++j) other[j] = __shfl_xor_sync(kWholeWarp, mine(from(j)), int(bits));
      } else {
        for (uint32_t j = 0; j < kAtOnce; ++j) s.key[j][lane] = mine(j);
        __syncthreads();
        for (uint32_t j = 0; j < kAtOnce; ++j) other[j] = s.key[from(j)][lane ^ bits];
        __syncthreads();
      }
      for (uint32_t j = 0; j < kAtOnce; ++j) mine(j) = (other[j] < mine(j)) != takesLarger ? other[j] : mine(j);
    }
  }
};

}  // namespace gw::GW_DEVICE

#endif
