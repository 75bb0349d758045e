// Which device plays: what --device means on this machine.
#pragma once

#include <memory>
#include <string>

#include "game/command_line.h"
#include "game/sim/simulation.h"

namespace gw {

struct DeviceChoice {
  bool cuda = false;
  std::string why;  // one line when `auto` had to take the cpu; else empty
};

// Throws UserError when --device cuda is asked for and no such device answers.
DeviceChoice chooseDevice(DeviceOption option);

// Makes the game on the chosen device. Throws UserError when the device cannot hold it.
std::unique_ptr<Simulation> makeSimulation(const DeviceChoice& device, const SimulationConfig& config);

// The rules and options that a run is made of: what the command line says about how to compute it.
void setComputing(SimulationConfig& config, const Options& options);

}  // namespace gw
