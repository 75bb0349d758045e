// A side that is played in this process.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "game/desync/probe.h"

namespace gw {

class LocalProbe final : public Probe {
 public:
  // `make` makes the run's simulation, as it is before the first tick; `told` hears of every tick when it is first
  // played. Ticks end with the inputs.
  using Make = std::function<std::unique_ptr<Simulation>()>;
  using Told = std::function<void(const TickReport&)>;
  LocalProbe(Make make, std::vector<InputRecord> inputs, Told told = {});

  std::string name() const override { return simulation_->deviceName(); }
  void restart() override;
  std::vector<uint64_t> play(uint32_t ticks) override;
  void keep() override;
  void goBack() override;
  std::vector<StageHashes> playByStages() override;
  std::vector<uint64_t> blocks(const std::string& stage, const std::string& field) override;
  std::vector<uint64_t> values(const std::string& stage, const std::string& field, uint32_t block) override;
  FieldValue global(const std::string& stage, const std::string& field) override;
  std::vector<FieldValue> entity(const std::string& stage, uint32_t id) override;
  std::vector<NearEntity> around(const std::string& stage, uint32_t id, uint32_t count) override;

 private:
  const StageState& stageOf(const std::string& stage) const;
  const Column& columnOf(const std::string& stage, const std::string& field) const;
  void hear(const TickReport& report);

  Make make_;
  std::vector<InputRecord> inputs_;
  Told told_;
  std::unique_ptr<Simulation> simulation_;
  uint32_t tick_ = 0, heard_ = 0;
  std::optional<Snapshot> kept_;  // none: the start
  uint32_t keptTick_ = 0;
  std::vector<StageState> stages_;
};

}  // namespace gw
