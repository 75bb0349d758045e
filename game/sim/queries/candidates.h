// How much work the broad phase leaves to the narrow phase: a measurement, not a stage.
#pragma once

#include "game/sim/state.h"

namespace gw::GW_DEVICE {

class Candidates {
 public:
  Candidates() = default;
  Candidates(Queue& queue, uint32_t capacity)
      : tested_(queue, capacity), found_(queue, capacity), sum_(queue, capacity), total_(queue, 1) {}

  // Every living enemy gathers within its vision around its position when the last tick was
  // maintained, and sums pair tests and neighbours, itself not counted. Waits for the queue, and times the search
  // alone.
  CandidateCount run(Queue& queue, const View& view);

 private:
  uint64_t sumOf(Queue& queue, const Buffer<uint64_t>& words);

  Buffer<uint64_t> tested_, found_;
  Reduce sum_;
  Buffer<uint64_t> total_;
};

}  // namespace gw::GW_DEVICE
