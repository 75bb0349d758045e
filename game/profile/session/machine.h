// What a session was measured on, and whether it had the machine to itself.
#pragma once

#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "game/profile/metrics/report.h"

namespace gw::profile {

// Processor, system, compiler, commit and load.
Machine thisMachine();
// A GPU at one moment, as the driver's own tool tells of it. NaN: it does not say.
struct GpuState {
  std::string name, driver;
  double clock_MHz, power_W, temperature_C;
};
// The one whose name `device` (Simulation::deviceName()) holds, else the first; nothing where there is no such tool.
std::optional<GpuState> askGpu(const std::string& device);
// The same out of that tool's lines.
std::optional<GpuState> gpuStateIn(const std::string& lines, const std::string& device);
// The means of several such moments.
void tellGpu(Machine& machine, const std::vector<GpuState>& states);

// How many processors the lines of /proc/stat are about.
uint32_t processorsIn(std::istream& stat);

double loadAverage();  // of one minute; unknown where the system does not say

// The share of all processors' time that others took between construction and othersShare(): 0 to 1, unknown where the
// system does not say.
class MachineUse {
 public:
  MachineUse();
  double othersShare() const;

 private:
  double busy_s_, own_s_, wall_s_;
};

}  // namespace gw::profile
