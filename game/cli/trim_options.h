// gpuwars trim FILE --out OUT: how much of a replay is kept, and where it goes.
#pragma once

#include "game/cli/computing_options.h"
#include "host/platform/exit_code.h"

namespace gw {

struct TrimOptions : ComputingOptions {
  static constexpr const char* kName = "trim";
  static constexpr const char* kSummary = "Run a replay again up to a tick and write that part in the current format.";

  std::filesystem::path file;
  std::filesystem::path outPath;  // may be `file`
  uint32_t toTick = 0;            // 0: the last

  void declare(OptionSet& options);
  void check() { checkComputing(GameSource::replay); }
};

ExitCode runVerb(const TrimOptions& options);  // game/commands/trim.cpp

}  // namespace gw
