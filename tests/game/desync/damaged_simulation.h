// A cpu device that damages its own memory once: in one tick, after one stage. Otherwise as any.
#pragma once

#include <functional>

#include "game/sim/debug/inspection.h"

namespace gw::test {

struct DamageAt {
  uint32_t tick = 1;
  std::string stage;
  std::function<void(Inspection&)> damage;
};

class DamagedSimulation final : public Simulation, private Inspection {
 public:
  DamagedSimulation(const SimulationConfig& config, DamageAt at)
      : real_(cpu::makeSimulation(config)), at_(std::move(at)) {}

  // One at a time: a report is always of the last tick.
  void tick(const InputRecord& input) override {
    reports_.push_back(tickByStages(input, [](const std::string&) {}));
  }
  TickReport report() override {
    const TickReport oldest = reports_.front();
    reports_.erase(reports_.begin());
    return oldest;
  }
  Snapshot snapshot() override { return real_->snapshot(); }
  void restore(const Snapshot& snapshot) override { real_->restore(snapshot); }
  void drawList(const DrawView& view, const DrawTarget& target) override { real_->drawList(view, target); }
  void particleList(const DrawView& view, float since, const ParticleTarget& target) override {
    real_->particleList(view, since, target);
  }
  std::vector<Particle> particles() const override { return real_->particles(); }
  std::optional<EntityRecord> inspect(float x, float y, float r) override { return real_->inspect(x, y, r); }
  CandidateCount countCandidates() override { return real_->countCandidates(); }
  Census census() override { return real_->census(); }
  Inspection& inspection() override { return *this; }
  void enableStageTimes(bool on) override { real_->enableStageTimes(on); }
  bool timesStages() const override { return real_->timesStages(); }
  std::vector<StageTime> stageTimes() const override { return real_->stageTimes(); }
  uint32_t launchesPerTick() const override { return real_->launchesPerTick(); }
  const SimulationConfig& config() const override { return real_->config(); }
  size_t deviceBytes() const override { return real_->deviceBytes(); }
  uint32_t capacity() const override { return real_->capacity(); }
  float worldWidth_m() const override { return real_->worldWidth_m(); }
  float worldHeight_m() const override { return real_->worldHeight_m(); }
  std::string deviceName() const override { return "damaged"; }
  bool onCuda() const override { return false; }
  void park() override { real_->park(); }

 private:
  TickReport tickByStages(const InputRecord& input, const AfterStage& after) override {
    Inspection& inside = real_->inspection();
    bool damages = false;
    return inside.tickByStages(input, [&](const std::string& stage) {
      if (stage == at_.stage) {
        const StageState now = inside.stateAfter(stage, nullptr);
        for (const Column& column : now.globals) {
          if (column.name == "tick") damages = column.values->front() == at_.tick;
        }
        if (damages) at_.damage(inside);
      }
      after(stage);
    });
  }
  StageState stateAfter(const std::string& stage, const StageState* before) override {
    return real_->inspection().stateAfter(stage, before);
  }
  std::vector<BytesOfBuffer> bytes() override { return real_->inspection().bytes(); }
  void flip(const BytesOfBuffer& part, uint32_t element, uint32_t bit) override {
    real_->inspection().flip(part, element, bit);
  }

  std::unique_ptr<Simulation> real_;
  DamageAt at_;
  std::vector<TickReport> reports_;
};

}  // namespace gw::test
