// How much work the broad phase leaves to the narrow phase: a measurement, not a stage.
#pragma once

#include "game/sim/state.h"

namespace gw::GW_DEVICE {

class Candidates {
 public:
  Candidates() = default;
  Candidates(Queue& queue, uint32_t capacity) : tested_(queue, capacity), sum_(queue, capacity), total_(queue, 1) {}

  // Lets every living enemy gather within its vision around where it stood when the last tick was
  // maintained, and sums the pair tests, its own not counted.
  CandidateCount run(Queue& queue, const View& view);

 private:
  Buffer<uint64_t> tested_;
  Reduce sum_;
  Buffer<uint64_t> total_;
};

}  // namespace gw::GW_DEVICE
