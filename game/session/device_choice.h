// Which device plays: what --device means on this machine.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "game/cli/computing_options.h"
#include "game/sim/simulation.h"

namespace gw {

struct DeviceChoice {
  bool cuda = false;
  bool automatic = true;  // --device auto: may end up elsewhere than it began
  std::string why{};      // one line when `auto` had to take the cpu; else empty
  // Shared by copies: the device failed, and no later game of this process tries it again.
  std::shared_ptr<std::atomic<bool>> lost = std::make_shared<std::atomic<bool>>(false);
};

// Throws UserError when --device cuda is asked for and no such device answers.
DeviceChoice chooseDevice(DeviceOption option);

// Tells the player, on stdout, why it is not a GPU that plays; says nothing when one does or was not wanted.
void sayWhy(const DeviceChoice& device);

// Makes the game on the chosen device. Throws UserError when the device cannot hold it; but when `auto` chose cuda, and
// cuda fails at the start, says so on stderr and takes the cpu.
std::unique_ptr<Simulation> makeSimulation(const DeviceChoice& device, const SimulationConfig& config);

// The same for an interactive game: it goes on with the cpu when its device fails, and reports that on stderr.
std::unique_ptr<Simulation> makeLastingSimulation(const DeviceChoice& device, const SimulationConfig& config);

// The rules and options that a run is made of: what the command line says about how to compute it.
void setComputing(SimulationConfig& config, const ComputingOptions& options);

// The same for a run that was recorded in `file`: config holds what the file says. Throws UserError when the
// command line asks for another game than the one in the file.
void setComputingOf(SimulationConfig& config, const ComputingOptions& options, const std::string& file);

// How neighbours are found, where it changes the game: "adaptive gather, bitonic sort"; empty for an exact game. No
// sort: the usual one.
std::string neighboursText(Gather gather, std::optional<Sort> sort);

}  // namespace gw
