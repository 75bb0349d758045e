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
  config.gather = options.gather.value_or(Gather::exact);
  config.sort = options.sort;
  config.broadPhase = options.broadPhase;
  config.threads = options.threads;
  config.order = options.order;
  config.protectMemory = options.protectMemory;
}

void setComputingOf(SimulationConfig& config, const Options& options, const std::string& file) {
  const bool exact = config.gather == Gather::exact;  // then the sort is no matter of the game's
  const auto refuse = [&](const std::string& asked) {
    const std::string sort = exact ? "" : std::string(" --sort ") + nameOf(config.sortInUse());
    throw UserError(ExitCode::badUsage, file + " was recorded with '--gather " + nameOf(config.gather) + sort +
                                            "': leave out " + asked + ".");
  };
  const bool otherSort =
      options.sort && *options.sort != config.sortInUse() && !(exact && options.sort != Sort::oddEven);
  const bool other = (options.gather && *options.gather != config.gather) || otherSort;
  if (options.thesis && other) refuse("'--thesis'");
  if (options.gather && *options.gather != config.gather)
    refuse(std::string("'--gather ") + nameOf(*options.gather) + "'");
  if (otherSort) refuse(std::string("'--sort ") + nameOf(*options.sort) + "'");
  if (config.gather != Gather::exact && options.broadPhase != BroadPhase::ngrid)
    refuse(std::string("'--broad-phase ") + nameOf(options.broadPhase) + "'");
  Options agreed = options;
  agreed.gather = config.gather;
  if (!exact) agreed.sort = config.sortInUse();
  setComputing(config, agreed);
}

std::string neighboursText(Gather gather, std::optional<Sort> sort) {
  if (gather == Gather::exact) return "";
  return std::string(nameOf(gather)) + " gather, " + nameOf(sort.value_or(usualSort(gather))) + " sort";
}

}  // namespace gw
