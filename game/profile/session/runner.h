// Plays a scene once with one contender and takes the time of every frame.
#pragma once

#include <functional>

#include "game/profile/metrics/frame.h"
#include "game/profile/session/contender_choice.h"
#include "game/profile/session/picture.h"
#include "game/profile/session/scene.h"
#include "host/platform/user_error.h"

namespace gw::profile {

struct RunPlan {
  uint32_t ticks = 0;         // at most the scene's
  uint32_t warmUp_ticks = 0;  // the first ones, which are marked
  bool paced = false;         // ticks when they are due, as in play; else a tick a frame
};

// The scene did not play as it was recorded.
struct SceneDesync : UserError {
  explicit SceneDesync(const std::string& sentence) : UserError(ExitCode::desync, sentence) {}
};

struct PlayedRun {
  RunFrames frames;
  uint64_t hash = 0;   // of the last tick
  bool whole = false;  // false: `goOn` ended it
};

class Runner {
 public:
  // `config` plays the scene, `picture` may be null: then nothing is drawn. `device` makes the simulations. All must
  // outlive this.
  Runner(const Scene& scene, const SimulationConfig& config, const MakeSimulation& device, Picture* picture)
      : scene_(scene), config_(config), make_(device), picture_(picture) {}

  // Is told every frame; false ends the run after it.
  using Listener = std::function<bool(const Frame&)>;

  // Throws SceneDesync at the first tick whose hash is not the recorded one.
  PlayedRun play(const ContenderChoice& contender, const RunPlan& plan, const Listener& listener);

 private:
  SimulationConfig configOf(const ContenderChoice& contender) const;
  PlayedRun playExact(const SimulationConfig& config, const RunPlan& plan, const Listener& listener);
  PlayedRun playShadow(const SimulationConfig& config, const RunPlan& plan, const Listener& listener);
  void tick(Run& run) const;
  void check(const TickReport& report) const;

  const Scene& scene_;
  const SimulationConfig& config_;
  const MakeSimulation& make_;
  Picture* picture_;
  std::string contender_;  // that plays
};

}  // namespace gw::profile
