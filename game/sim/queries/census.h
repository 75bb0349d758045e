// Live counts by type, for displays: a measurement, not a stage.
#pragma once

#include "game/sim/state.h"

namespace gw::GW_DEVICE {

class CensusTaker {
 public:
  CensusTaker() = default;
  explicit CensusTaker(Queue& queue) : counts_(queue, kCounts) {}

  // `view` is of the tick that comes next: its cells are the end of the last one, and what it calls moved is where
  // neighbours were searched. Waits for the queue.
  Census run(Queue& queue, const View& view, Neighbourhood& neighbourhood);

  // The living by type, and at the end all in the grid that was searched.
  static constexpr uint32_t kCounts = kTypeCount + 1;

 private:
  Buffer<uint32_t> counts_;
};

}  // namespace gw::GW_DEVICE
