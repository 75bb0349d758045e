// What a session was measured on, and whether it had the machine to itself.
#pragma once

#include "game/profile/figures/report.h"

namespace gw::profile {

// Processor, system, compiler, commit and load.
Machine thisMachine();
// The first GPU that the driver's own tool lists, with the clocks it has now; nothing where there is no such tool.
void askGpu(Machine& machine);

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
