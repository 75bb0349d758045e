#include "game/device_choice.h"

#include <new>

#include "game/user_error.h"
#include "gpu/device_list.h"

namespace gw {

DeviceChoice chooseDevice(DeviceOption option) {
  if (option == DeviceOption::cpu) return {};
  const DeviceList list = listDevices();
  if (list.hasCuda()) return {.cuda = true, .why = {}};
  if (option == DeviceOption::cuda) {
    throw UserError(ExitCode::failedRun, list.cudaMissing + " Choose --device cpu: it plays the same game.");
  }
  return {.cuda = false, .why = list.cudaMissing + " The cpu device plays the same game."};
}

std::unique_ptr<Simulation> makeSimulation(const DeviceChoice& device, const SimulationConfig& config) {
  try {
#ifdef GW_HAVE_CUDA
    if (device.cuda) return cuda::makeSimulation(config);
#endif
    (void)device;
    return cpu::makeSimulation(config);
  } catch (const std::bad_alloc&) {
    throw UserError(ExitCode::failedRun, "Not enough memory for " + std::to_string(config.enemies) +
                                             " enemies: choose a smaller --enemies.");
  }
}

void setComputing(SimulationConfig& config, const Options& options) {
  config.broadPhase = options.broadPhase;
  config.threads = options.threads;
  config.order = options.order;
  config.protectMemory = options.protectMemory;
}

}  // namespace gw
