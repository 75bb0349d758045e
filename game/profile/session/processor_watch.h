// What a session could count on its processors for: which it was allowed, for how much of the time, at which clocks.
// Two sessions under other conditions measure other things, whatever the machine.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "game/profile/metrics/report.h"
#include "game/profile/session/clocks.h"
#include "gpu/devices/processors.h"

namespace gw::profile {

class ProcessorWatch {
 public:
  // `root` holds /proc and /sys: tests give another one.
  explicit ProcessorWatch(std::filesystem::path root = "/");

  // From construction until now. What has changed meanwhile is told as "powersave, then performance".
  ProcessorState state() const;

  // Whole sentences for `state`: clocks that are moved, and a quota that held the session up.
  std::vector<std::string> warnings(const ProcessorState& state) const;

 private:
  std::filesystem::path root_;
  Processors processors_;
  Clocks clocks_;
  double throttled_s_;
};

}  // namespace gw::profile
