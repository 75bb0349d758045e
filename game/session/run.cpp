#include "game/session/run.h"

#include <stdexcept>
#include <utility>

namespace gw {

Run::Run(std::unique_ptr<Simulation> simulation, std::optional<Recorder> recorder)
    : simulation_(std::move(simulation)), recorder_(std::move(recorder)) {}

void Run::queue(const InputRecord& input) {
  simulation_->tick(input);
  ++queued_;
}

bool Run::collect() {
  const TickReport report = simulation_->report();
  --queued_;
  if (over()) return false;
  if (recorder_ && !recorder_->append(report)) finishRecording();  // full, four hours: with the last tick that it holds
  monitor_.add(report);
  effects_.add(report);
  if (over()) finishRecording();
  return true;
}

void Run::restore(const RunSnapshot& snapshot) {
  simulation_->restore(snapshot.state);
  monitor_ = snapshot.monitor;
  effects_ = snapshot.effects;
}

void Run::replaceSimulation(std::unique_ptr<Simulation> simulation) {
  if (queued_ > 0) throw std::logic_error("Ticks are queued: collect them before the simulation is replaced.");
  simulation_ = std::move(simulation);
}

void Run::finishRecording() {
  if (!recorder_) return;
  Recorder recorder = std::move(*recorder_);
  recorder_.reset();
  if (recorder.ticks() == 0) return;
  const TickReport& report = last();
  recorder.finish({report.score, report.kills, report.frameTime_us, report.over != 0});
  recorded_ = true;
}

}  // namespace gw
