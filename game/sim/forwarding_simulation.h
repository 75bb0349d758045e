// A simulation that forwards every call to another one: the base class of those that change a few of the calls.
#pragma once

#include <utility>

#include "game/sim/simulation.h"

namespace gw {

class ForwardingSimulation : public Simulation {
 public:
  explicit ForwardingSimulation(std::unique_ptr<Simulation> device) : device_(std::move(device)) {}

  void tick(const InputRecord& input) override { device().tick(input); }
  TickReport report() override { return device().report(); }
  Snapshot snapshot() override { return device().snapshot(); }
  void restore(const Snapshot& snapshot) override { device().restore(snapshot); }
  void drawList(const DrawView& view, const DrawTarget& target) override { device().drawList(view, target); }
  void particleList(const DrawView& view, float sinceTick_ticks, const ParticleTarget& target) override {
    device().particleList(view, sinceTick_ticks, target);
  }
  std::vector<Particle> particles() const override { return device_->particles(); }
  std::optional<EntityRecord> inspect(float x, float y, float radius_m) override {
    return device().inspect(x, y, radius_m);
  }
  CandidateCount countCandidates() override { return device().countCandidates(); }
  Census census() override { return device().census(); }
  void enableStageTimes(bool on) override { device().enableStageTimes(on); }
  bool timesStages() const override { return device_->timesStages(); }
  std::vector<StageTime> stageTimes() const override { return device_->stageTimes(); }
  Inspection& inspection() override { return device().inspection(); }
  uint32_t launchesPerTick() const override { return device_->launchesPerTick(); }
  size_t deviceBytes() const override { return device_->deviceBytes(); }
  const SimulationFacts& facts() const override { return device_->facts(); }
  void park() override { device().park(); }

 protected:
  // What calls that may reach the device's memory go to.
  virtual Simulation& device() { return *device_; }

  std::unique_ptr<Simulation> device_;
};

}  // namespace gw
