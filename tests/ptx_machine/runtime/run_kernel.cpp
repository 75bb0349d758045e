#include "tests/ptx_machine/runtime/run_kernel.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "tests/ptx_machine/runtime/allocation_origin.h"
#include "tests/ptx_machine/runtime/ptx_device.h"

namespace gw::ptx {
namespace {

std::vector<uint8_t> parameterBlock(const Kernel& kernel, void** arguments) {
  std::vector<uint8_t> block(kernel.parameter_bytes);
  for (size_t p = 0; p < kernel.parameters.size(); ++p) {
    const Variable& parameter = kernel.parameters[p];
    std::memcpy(block.data() + parameter.offset_bytes, arguments[p], parameter.bytes);
  }
  return block;
}

// The module's variables, which begin with their initial values and keep what kernels write.
uint64_t globalsOf(const Module& module) {
  uint64_t bytes = 0;
  for (const Variable& variable : module.globals) bytes = std::max(bytes, variable.offset_bytes + variable.bytes);
  if (bytes == 0) return 0;
  uint64_t& at = device().globals[&module];
  if (at != 0) return at;
  auto* begin = static_cast<uint8_t*>(device().memory->allocate(bytes, "the variables of " + module.name));
  if (!begin) return 0;
  std::memset(begin, 0, bytes);
  for (const Variable& variable : module.globals) {
    std::memcpy(begin + variable.offset_bytes, variable.initial.data(), variable.initial.size());
  }
  device().memory->hostWrote(begin, bytes);
  return at = uint64_t(uintptr_t(begin));
}

// A block of CUB's scans and sorts waits for those with lower numbers, which a GPU starts first.
bool looksBack(const Code& code) {
  return std::string_view(code.name).find("3cub") != std::string_view::npos;
}

void printNewFaults(Device& machine) {
  const std::vector<Fault>& faults = machine.memory->faults();
  for (; machine.faultsPrinted < faults.size(); ++machine.faultsPrinted) {
    const Fault& fault = faults[machine.faultsPrinted];
    std::fprintf(stderr, "PTX machine: %s: %s\n%s", fault.kind.c_str(), fault.text.c_str(),
                 originsOf(fault.text).c_str());
  }
}

void runNow(Launch& launch) {
  Device& machine = device();
  const uint64_t before = machine.memory->faults().size();
  ++stand_in::driver().kernels;
  launch.serial = ++machine.launches;
  launch.memory = machine.memory.get();
  runLaunch(launch);
  if (machine.memory->faults().size() == before) return;
  printNewFaults(machine);
  if (machine.options.stopAtFault) stand_in::deviceFailed(cudaErrorLaunchFailure);
}

}  // namespace

stand_in::Work kernelWork(const LoadedKernel& kernel, Size3 grid, Size3 block, uint32_t dynamicShared_bytes,
                          void** arguments) {
  Launch launch;
  launch.code = kernel.code;
  launch.grid = grid;
  launch.block = block;
  launch.dynamicShared_bytes = dynamicShared_bytes;
  launch.moduleGlobals = globalsOf(*kernel.module);
  launch.parameters = parameterBlock(*kernel.text, arguments);
  launch.options = device().options.machine;
  if (looksBack(*kernel.code)) launch.options.order = Order::ascending;
  return [launch = std::move(launch)]() mutable { runNow(launch); };
}

}  // namespace gw::ptx
