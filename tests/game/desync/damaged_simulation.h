// A cpu device that damages its own memory once: in one tick, after one stage. Otherwise as any.
#pragma once

#include <functional>

#include "game/sim/debug/inspection.h"
#include "game/sim/forwarding_simulation.h"

namespace gw::test {

struct DamageAt {
  uint32_t tick = 1;
  std::string stage;
  std::function<void(Inspection&)> damage;
};

class DamagedSimulation final : public ForwardingSimulation, private Inspection {
 public:
  DamagedSimulation(const SimulationConfig& config, DamageAt at)
      : ForwardingSimulation(cpu::makeSimulation(config)), at_(std::move(at)), facts_(device_->facts()) {
    facts_.deviceName = "damaged";
  }

  // One at a time: a report is always of the last tick.
  void tick(const InputRecord& input) override {
    reports_.push_back(tickByStages(input, [](const std::string&) {}));
  }
  TickReport report() override {
    const TickReport oldest = reports_.front();
    reports_.erase(reports_.begin());
    return oldest;
  }
  Inspection& inspection() override { return *this; }
  const SimulationFacts& facts() const override { return facts_; }

 private:
  TickReport tickByStages(const InputRecord& input, const AfterStage& after) override {
    Inspection& inside = device_->inspection();
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
    return device_->inspection().stateAfter(stage, before);
  }
  std::vector<BytesOfBuffer> bytes() override { return device_->inspection().bytes(); }
  void flip(const BytesOfBuffer& part, uint32_t element, uint32_t bit) override {
    device_->inspection().flip(part, element, bit);
  }

  DamageAt at_;
  SimulationFacts facts_;
  std::vector<TickReport> reports_;
};

}  // namespace gw::test
