// What a session plays. Every scene is a recorded run before anything is measured: all contenders get the same inputs
// and must reach the recorded hash of every tick.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "game/cli/scene_kind.h"
#include "game/replay/replay.h"

namespace gw::profile {

struct Scene {
  std::string name, about;
  Replay replay;
  bool title = false;  // the title is drawn over it
};

const char* nameOf(SceneKind kind);
uint32_t usualTicks(SceneKind kind);

struct SceneSize {
  uint32_t enemies = 8192;
  uint32_t ticks = 0;  // 0: the usual
  uint64_t seed = 1;
};

// Makes a simulation that plays from its start; on whichever device.
using MakeSimulation = std::function<std::unique_ptr<Simulation>(const SimulationConfig&)>;

// Plays it once, unmeasured. `goOn` is told the ticks that are done; false ends it there. The scene has at least one
// tick, fewer than asked for where the run was over before.
Scene recordScene(SceneKind kind, const SceneSize& size, const RuleTexts& rules, const MakeSimulation& make,
                  const std::function<bool(uint32_t)>& goOn);

// The committed recording of the five minutes, in the assets. Throws ReplayError.
Scene readFiveMinutes(const std::filesystem::path& assets);

// A replay of the user's. Throws ReplayError.
Scene readScene(const std::filesystem::path& file);

// The first ticks of it.
void cutTo(Scene& scene, uint32_t ticks);

}  // namespace gw::profile
