// The draw list: the entities in the view, as sprites, in an order that keeps threats on top. Once per frame,
// outside the tick.
#pragma once

#include "game/sim/state.h"

namespace gw::GW_DEVICE {

// Layers from the bottom: bits, shots, announced enemies, enemies; the ship comes last. Within a layer by
// id. When more is in view than the target holds, the bottom layers give way.
class DrawList {
 public:
  static constexpr uint32_t kLayers = 4;

  DrawList() = default;
  DrawList(Queue& queue, uint32_t capacity);

  // Writes target.vertices and target.command; `view` is of the tick that comes next, so that its cells
  // are the end of the last one.
  void run(Queue& queue, const View& view, const DrawView& window, const DrawTarget& target);

 private:
  uint32_t capacity_ = 0;
  Scan twoLayers_[kLayers / 2];  // counts of two layers each
};

}  // namespace gw::GW_DEVICE
