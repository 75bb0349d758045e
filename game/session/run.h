// One run of the game: the simulation, its recording, and what is known of it so far.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "game/effects/run_effects.h"
#include "game/replay/recorder.h"
#include "game/session/run_monitor.h"
#include "game/sim/simulation.h"

namespace gw {

// A run at one tick: all it takes to go on from there, and to show it as if it had been played to there.
struct RunSnapshot {
  Snapshot state;
  RunMonitor monitor;
  RunEffects effects;

  uint32_t tick() const { return monitor.last().tick; }
};

class Run {
 public:
  // `recorder` may be none. The simulation has not ticked yet.
  Run(std::unique_ptr<Simulation> simulation, std::optional<Recorder> recorder);

  // Queues a tick. At most Simulation::kTicksInFlight may wait for collect().
  void queue(const InputRecord& input);
  // Reads the oldest report; what comes after the end is dropped. True when it was a tick of the run.
  bool collect();
  // Both: what play does, so that every tick is shown.
  bool tick(const InputRecord& input) {
    queue(input);
    return collect();
  }
  uint32_t queued() const { return queued_; }

  // No tick may be queued, and what is restored must come from a run of the same game. Sparks are no state: those
  // that flew are gone after restore().
  RunSnapshot snapshot() { return {simulation_->snapshot(), monitor_, effects_}; }
  void restore(const RunSnapshot& snapshot);

  // Goes on with another simulation of the same game at the same tick; none may be queued.
  void replaceSimulation(std::unique_ptr<Simulation> simulation);

  // Writes the recording, if there is one and a tick was played; once. At the end of the run this has
  // been done already, so that nothing that happens later can lose it. Throws FileError.
  void finishRecording();
  bool recorded() const { return recorded_; }  // a file was written

  bool over() const { return last().over != 0; }
  const TickReport& last() const { return monitor_.last(); }
  const RunMonitor& monitor() const { return monitor_; }
  const RunEffects& effects() const { return effects_; }
  Simulation& simulation() { return *simulation_; }

 private:
  std::unique_ptr<Simulation> simulation_;
  std::optional<Recorder> recorder_;
  RunMonitor monitor_;
  RunEffects effects_;
  uint32_t queued_ = 0;
  bool recorded_ = false;
};

}  // namespace gw
