// gpuwars verify FILE...: which replays run again, beside what, and where the results go.
#pragma once

#include <vector>

#include "game/cli/computing_options.h"
#include "host/platform/exit_code.h"

namespace gw {

struct VerifyOptions : ComputingOptions {
  static constexpr const char* kName = "verify";
  static constexpr const char* kSummary = "Run replays again and compare every tick.";

  std::vector<std::filesystem::path> files;
  uint32_t jobs = 1;                    // replays at the same time
  bool heavy = false;                   // every tick's state is taken as a snapshot and restored
  std::optional<DeviceOption> against;  // another device plays beside
  std::filesystem::path reference;      // another program plays beside; empty: none
  std::string referenceOptions;         // its own, with spaces between them
  std::filesystem::path jsonPath;       // "-" is stdout
  std::filesystem::path hashesPath;     // one line a tick; "-" is stdout
  std::filesystem::path junitPath;      // the results for continuous integration

  void declare(OptionSet& options);
  void check();
};

ExitCode runVerb(const VerifyOptions& options);  // game/commands/verify.cpp

}  // namespace gw
