#include "game/sim/stages.h"
#include "game/sim/step.h"

namespace gw::GW_DEVICE {

void step(Queue& queue, GameState& state, uint32_t parity, Autopilot who, StageTimer& timer, Particles* particles) {
  const View v = state.view(parity);
  timer.time(queue, "autopilot", [&] { autopilot(queue, v, who); });
  timer.time(queue, "logic", [&] { logic(queue, v); });
  timer.time(queue, "spawn", [&] { spawn(queue, v, state.birthScan()); });
  timer.time(queue, "maintain", [&] { maintain(queue, v, state.neighbourhood()); });
  timer.time(queue, "think", [&] { think(queue, v); });
  timer.time(queue, "integrate", [&] { integrate(queue, v); });
  timer.time(queue, "collide", [&] { collide(queue, v); });
  timer.time(queue, "settle", [&] { settle(queue, v); });
  timer.time(queue, "hash", [&] { hash(queue, v); });
  if (particles) timer.time(queue, "particles", [&] { particles->emit(queue, v, parity); });
}

}  // namespace gw::GW_DEVICE
