// gpuwars devices: where the list goes.
#pragma once

#include <filesystem>

#include "host/platform/exit_code.h"

namespace gw {

class OptionSet;

struct DevicesOptions {
  static constexpr const char* kName = "devices";
  static constexpr const char* kSummary = "List the devices and show which one 'auto' selects.";

  std::filesystem::path jsonPath;  // "-" is stdout; empty: a list for people

  void declare(OptionSet& options);
  void check() {}
};

ExitCode runVerb(const DevicesOptions& options);  // game/commands/devices.cpp

}  // namespace gw
