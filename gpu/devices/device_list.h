// Which devices there are, and why no CUDA device computes when none does.
#pragma once

#include <gpuwars/cuda_state.h>
#include <gpuwars/processors.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gw {

// One device.
struct DeviceInfo {
  std::string kind;         // "cuda" or "cpu"
  std::string name;         // as the device calls itself
  std::string detail{};     // one line: capability and memory, or threads and what limits them
  int architecture = 0;     // cuda: compute capability, e.g. 90
  uint64_t memory_MiB = 0;  // cuda
  std::string problem{};    // cuda: why this program's kernels cannot run on it; empty when they can
};

// All of this machine.
struct DeviceList {
  std::vector<DeviceInfo> devices;         // cuda ones first, in CUDA's order; the cpu device is always there
  CudaState cudaState = CudaState::ready;  // ready: one computes
  std::string cudaMissing;    // why no cuda device computes, one sentence with a remedy; empty when one does
  std::string driverRelease;  // of the NVIDIA driver, e.g. "580.65.06"; empty: not known
  int driverVersion = 0;      // the newest CUDA that it supports, e.g. 13020 for 13.2; 0: there is no driver
  int runtimeVersion = 0;     // the CUDA of this build; 0: it has no cuda device
  Processors processors;      // of the cpu device
  // Whether a cuda device computes.
  bool hasCuda() const { return cudaMissing.empty(); }
};

// Asks the driver; any error counts as "no device". Never throws.
DeviceList listDevices();

// The CUDA device that simulations are made on: the first, unless this program has chosen another. Nothing when none
// answers.
std::optional<int> currentCudaDevice();

}  // namespace gw
