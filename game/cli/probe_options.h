// gpuwars probe FILE: which replay is played for another build.
#pragma once

#include "game/cli/computing_options.h"
#include "host/platform/exit_code.h"

namespace gw {

struct ProbeOptions : ComputingOptions {
  static constexpr const char* kName = "probe";
  static constexpr const char* kSummary = "Serve 'gpuwars verify --reference' of another build.";

  std::filesystem::path file;

  void declare(OptionSet& options);
  void check() { checkComputing(GameSource::replay); }
};

ExitCode runVerb(const ProbeOptions& options);  // game/commands/probe.cpp

}  // namespace gw
