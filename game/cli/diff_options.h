// gpuwars diff FILE FILE: which replays are compared.
#pragma once

#include <filesystem>
#include <vector>

#include "host/platform/exit_code.h"

namespace gw {

class OptionSet;

struct DiffOptions {
  static constexpr const char* kName = "diff";
  static constexpr const char* kSummary = "Show the first difference between two replays.";

  std::vector<std::filesystem::path> files;  // two
  std::filesystem::path jsonPath;            // "-" is stdout; empty: none

  void declare(OptionSet& options);
  void check() {}
};

ExitCode runVerb(const DiffOptions& options);  // game/commands/diff.cpp

}  // namespace gw
