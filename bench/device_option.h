// --device cpu|cuda of programs that measure or compare one device.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "gpu/devices/device_list.h"
#include "gpu/exec/kernel_count.h"

namespace gw::bench {

inline void addDeviceOption(CLI::App& app, std::string& device) {
  app.add_option("--device", device, "cpu (as it is now) or cuda")->check(CLI::IsMember({"cpu", "cuda"}));
}

// Whether it means cuda. Throws, in one sentence, when it does and no such device answers.
inline bool takesCuda(const std::string& device) {
  if (device != "cuda") return false;
  const DeviceList list = listDevices();
  if (!list.hasCuda()) throw std::runtime_error(list.cudaMissing + " Choose --device cpu.");
  return true;
}

// The line by which tests/on_gpu adds up what really ran on a GPU.
inline void printKernelsRun() {
  std::printf("%llu CUDA kernels run\n", static_cast<unsigned long long>(cudaKernelsRun.load()));
}

}  // namespace gw::bench
