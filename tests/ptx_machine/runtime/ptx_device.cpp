// The seam of the driver (tests/fake_cuda/device_seam.h), for the PTX machine.
#include "tests/ptx_machine/runtime/ptx_device.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tests/fake_cuda/driver.h"
#include "tests/ptx_machine/runtime/allocation_origin.h"

namespace gw::ptx {
namespace {

void addFaults(Device& machine) {
  for (const Fault& fault : machine.memory->faults()) {
    ++machine.placesBefore;
    machine.timesBefore += fault.times;
  }
}

// When the program ends. What was found wrong ends no run, but no run that met it counts as good.
void endOfProgram(int status, void*) {
  Device& machine = device();
  addFaults(machine);
  if (machine.placesBefore == 0) return;
  std::fprintf(stderr, "PTX machine: faults at %llu places, met %llu times in %llu launches; see above.\n",
               static_cast<unsigned long long>(machine.placesBefore),
               static_cast<unsigned long long>(machine.timesBefore), static_cast<unsigned long long>(machine.launches));
  std::fflush(nullptr);
  if (status == 0) std::_Exit(kFaultsFoundStatus);
}

}  // namespace

Device& device() {
  static Device* made = [] {
    on_exit(endOfProgram, nullptr);
    return new Device;  // never destroyed: destructors of others may still call
  }();
  return *made;
}

void forgetFaults() {
  device().memory->clearFaults();
  device().faultsPrinted = 0;
}

// The device after a fault that ended it, or of another test.
void renewDevice() {
  addFaults(device());
  device().memory = std::make_unique<Memory>();
  device().allocations.clear();
  device().globals.clear();
  device().faultsPrinted = 0;
}

}  // namespace gw::ptx

namespace gw::stand_in {

using ptx::device;

const char* const kOptionsVariable = "GW_PTX_MACHINE";
const char* const kOptionsHelp = "tests/ptx_machine/runtime/machine_options.h";
const char* const kDeviceName = "PTX machine (no GPU)";

int deviceArchitecture() {
  return GW_PTX_ARCHITECTURE;
}

bool takeDeviceOption(Options&, const std::string& option) {
  return ptx::takeMachineOption(device().options, option);
}

void restartDevice() {
  ptx::renewDevice();
}

void* allocateDevice(size_t bytes) {
  void* pointer = device().memory->allocate(bytes, ptx::nameAllocation(bytes));
  if (pointer) device().allocations[uintptr_t(pointer)] = bytes;
  return pointer;
}

bool releaseDevice(void* pointer) {
  return device().allocations.erase(uintptr_t(pointer)) == 1 && device().memory->release(pointer);
}

bool isDevice(const void* pointer, size_t bytes) {
  const auto& allocations = device().allocations;
  auto after = allocations.upper_bound(uintptr_t(pointer));
  if (after == allocations.begin()) return false;
  --after;
  return uintptr_t(pointer) + bytes <= after->first + after->second;
}

void pinnedAllocated(void* pointer, size_t bytes) {
  device().memory->registerForeign(pointer, bytes, ptx::nameAllocation(bytes) + ", pinned");
}

void pinnedReleased(void* pointer) {
  device().memory->unregisterForeign(pointer);
}

void deviceWritten(void* pointer, size_t bytes) {
  device().memory->hostWrote(pointer, bytes);
}

void deviceForgotten(void* pointer, size_t bytes) {
  std::memset(pointer, kNeverWritten, bytes);
  device().memory->hostForgot(pointer, bytes);
}

}  // namespace gw::stand_in
