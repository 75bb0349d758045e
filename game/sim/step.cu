#include <stdexcept>

#include "game/sim/stages.h"
#include "game/sim/step.h"

namespace gw::GW_DEVICE {
namespace {

struct Tick {
  Queue& queue;
  const View view;
  GameState& state;
  uint32_t parity;
  Autopilot who;
  Particles* particles;
};

struct Stage {
  const char* name;  // of its time in profiles, of what it left in searches for a desync
  void (*run)(const Tick&);
  bool forParticles = false;  // left out of games without particles
};

// The stages of a tick, in order.
constexpr Stage kStages[] = {
    {"autopilot", [](const Tick& t) { autopilot(t.queue, t.view, t.who); }},
    {"logic", [](const Tick& t) { logic(t.queue, t.view); }},
    {"spawn", [](const Tick& t) { spawn(t.queue, t.view, t.state.birthScan()); }},
    {"maintain", [](const Tick& t) { maintain(t.queue, t.view, t.state.neighbourhood()); }},
    {"think", [](const Tick& t) { think(t.queue, t.view); }},
    {"integrate", [](const Tick& t) { integrate(t.queue, t.view); }},
    {"collide", [](const Tick& t) { collide(t.queue, t.view); }},
    {"settle", [](const Tick& t) { settle(t.queue, t.view); }},
    {"hash", [](const Tick& t) { hash(t.queue, t.view), report(t.queue, t.view); }},
    {"particles", [](const Tick& t) { t.particles->emit(t.queue, t.view, t.parity); }, true},
};

}  // namespace

void step(Queue& queue, GameState& state, uint32_t parity, Autopilot who, StageTimer& timer, Particles* particles) {
  const Tick tick{queue, state.view(parity), state, parity, who, particles};
  for (const Stage& stage : kStages) {
    if (stage.forParticles && !particles) continue;
    timer.time(queue, stage.name, [&] { stage.run(tick); });
  }
}

uint32_t stageNumber(const std::string& name) {
  for (const Stage& stage : kStages) {
    if (stage.name == name) return uint32_t(&stage - kStages);
  }
  throw std::logic_error("There is no stage '" + name + "' in a tick.");
}

}  // namespace gw::GW_DEVICE
