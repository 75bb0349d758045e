#include "game/session/device_choice.h"

#include <cstdio>
#include <new>

#include "game/session/failover.h"
#include "gpu/devices/device_list.h"
#include "host/platform/user_error.h"

namespace gw {

namespace {

std::unique_ptr<Simulation> makeOnCpu(const SimulationConfig& config) {
  try {
    return cpu::makeSimulation(config);
  } catch (const std::bad_alloc&) {
    throw UserError(ExitCode::failedRun, "Not enough memory for " + std::to_string(config.enemies) +
                                             " enemies: choose a smaller --enemies.");
  }
}

void say(const std::string& sentence) {
  std::fprintf(stderr, "%s\n", sentence.c_str());
}

}  // namespace

DeviceChoice chooseDevice(DeviceOption option) {
  if (option == DeviceOption::cpu) return {.cuda = false, .automatic = false};
  const bool automatic = option != DeviceOption::cuda;
  const DeviceList list = listDevices();
  if (list.hasCuda()) return {.cuda = true, .automatic = automatic};
  if (!automatic) {
    throw UserError(ExitCode::failedRun, list.cudaMissing + " Choose --device cpu: it plays the same game.");
  }
  return {.cuda = false, .why = list.cudaMissing + " The cpu device plays the same game."};
}

void sayWhy(const DeviceChoice& device) {
  if (device.why.empty()) return;
  std::printf("%s\n", device.why.c_str());
  std::fflush(stdout);
}

std::unique_ptr<Simulation> makeSimulation([[maybe_unused]] const DeviceChoice& device,
                                           const SimulationConfig& config) {
#ifdef GW_HAVE_CUDA
  if (device.cuda && !*device.lost) {
    try {
      return cuda::makeSimulation(config);
    } catch (const DeviceError& error) {
      if (!device.automatic) throw UserError(ExitCode::failedRun, error.what());
      // What has no room for this game may have some for the next.
      if (dynamic_cast<const DeviceOutOfMemory*>(&error) == nullptr) *device.lost = true;
      say(std::string(error.what()) + " The cpu device plays instead.");
    }
  }
#endif
  return makeOnCpu(config);
}

std::unique_ptr<Simulation> makeLastingSimulation(const DeviceChoice& device, const SimulationConfig& config) {
  std::unique_ptr<Simulation> first = makeSimulation(device, config);
  if (!first->onCuda()) return first;
  return std::make_unique<Failover>(
      std::move(first), [config] { return makeOnCpu(config); },
      [lost = device.lost](const std::string& why) {
        *lost = true;
        say(why + " The game goes on with the cpu device.");
      });
}

void setComputing(SimulationConfig& config, const ComputingOptions& options) {
  config.gather = options.gather.value_or(Gather::exact);
  config.sort = options.sort;
  config.broadPhase = options.broadPhase;
  config.threads = options.threads;
  config.order = options.order;
  config.protectMemory = options.protectMemory;
  config.blockSize = options.blockSize;
  config.checkLaunches |= options.cudaCheck;
}

void setComputingOf(SimulationConfig& config, const ComputingOptions& options, const std::string& file) {
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
  ComputingOptions agreed = options;
  agreed.gather = config.gather;
  if (!exact) agreed.sort = config.sortInUse();
  setComputing(config, agreed);
}

std::string neighboursText(Gather gather, std::optional<Sort> sort) {
  if (gather == Gather::exact) return "";
  return std::string(nameOf(gather)) + " gather, " + nameOf(sort.value_or(usualSort(gather))) + " sort";
}

}  // namespace gw
