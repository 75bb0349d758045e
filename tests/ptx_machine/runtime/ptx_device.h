// The device of the PTX machine: one, as long as the program runs.
#pragma once

#include <map>
#include <memory>

#include "tests/ptx_machine/machine/memory.h"
#include "tests/ptx_machine/runtime/machine_options.h"

namespace gw::ptx {

struct Device {
  MachineOptions options;
  std::unique_ptr<Memory> memory = std::make_unique<Memory>();
  std::map<uintptr_t, size_t> allocations;    // bytes, by address
  std::map<const Module*, uint64_t> globals;  // where its variables are
  uint64_t launches = 0;
  size_t faultsPrinted = 0;
  uint64_t placesBefore = 0, timesBefore = 0;  // of faults, on devices before a restart
};

// Made when the first kernel is registered or the first call made; the driver's lock is held around all uses.
Device& device();
// Those found so far do not count when the program ends: for tests that plant them.
void forgetFaults();

}  // namespace gw::ptx
