// The particles that live and are in view, as streaks, once per frame and outside the tick.
#pragma once

#include "game/sim/draw/particles.h"

namespace gw::GW_DEVICE {

class ParticleList {
 public:
  ParticleList() = default;
  ParticleList(Queue& queue, uint32_t size);

  // Writes target.vertices, the newest first, and target.command. When more is in view than the target
  // holds, the oldest are left out. `sinceTick_ticks` has passed since tick `globals->tick` was complete.
  void run(Queue& queue, const View& view, const ParticleView& particles, const DrawView& window, float sinceTick_ticks,
           const ParticleTarget& target);

 private:
  Scan ranks_;
};

}  // namespace gw::GW_DEVICE
