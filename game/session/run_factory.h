// Makes runs as the command line asks for them, one after the other, each with its own recording.
#pragma once

#include <filesystem>
#include <memory>

#include "game/cli/play_options.h"
#include "game/session/device_choice.h"
#include "game/session/run.h"
#include "game/tables/tables.h"

namespace gw {

class RunFactory {
 public:
  // Chooses the device and reads the rules. Throws UserError and TableError.
  explicit RunFactory(const PlayOptions& options);

  // A new run. `recorded`: with the recording that --record asks for; the second recorded run of a session
  // goes to FILE-2.gwr and so on, so that "again" never costs a recording.
  std::unique_ptr<Run> make(Mode mode, uint64_t seed, Autopilot autopilot, bool recorded);

  // A simulation of a run that make() has made, computed in another way.
  std::unique_ptr<Simulation> makeAgain(const SimulationConfig& config) const;

  const Rules& rules() const { return config_.rules; }
  const DeviceChoice& device() const { return device_; }
  const std::filesystem::path& assets() const { return assets_; }
  // Of the last recorded run; empty when there was none.
  const std::filesystem::path& recordPath() const { return recordPath_; }

 private:
  PlayOptions options_;
  std::filesystem::path assets_;
  DeviceChoice device_;
  RuleTexts texts_;
  SimulationConfig config_;
  std::filesystem::path recordPath_;
  uint32_t recordings_ = 0;
};

// A random seed.
uint64_t randomSeed();

}  // namespace gw
