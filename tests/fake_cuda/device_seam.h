// What the driver leaves to the build that it is in. There are two, from one source: the stand-in, whose kernels the
// C++ compiler compiled (stand_in_device.cpp, blocks.cpp), and the PTX machine, whose kernels nvcc compiled
// (tests/ptx_machine/runtime). Streams, graphs, events, pinned memory, faults and interop are the driver's.
#pragma once

#include <cstddef>
#include <string>

namespace gw::stand_in {

struct Options;

extern const char* const kOptionsVariable;  // the environment variable that holds the options...
extern const char* const kOptionsHelp;      // ... and the file that lists them
extern const char* const kDeviceName;

// The compute capability that kernels were compiled for, times ten.
int deviceArchitecture();

// Options that the driver does not know; false: nor does the device.
bool takeDeviceOption(Options& options, const std::string& option);
// All memory of the device is gone, and what was counted of it.
void restartDevice();

// Device memory. Fresh bytes are garbage. nullptr: there is no more of it.
void* allocateDevice(size_t bytes);
bool releaseDevice(void* pointer);  // false: it does not begin an allocation of the device
// Whether all these bytes lie in one allocation of the device.
bool isDevice(const void* pointer, size_t bytes);
// Pinned memory of the host, which kernels may use too.
void pinnedAllocated(void* pointer, size_t bytes);
void pinnedReleased(void* pointer);
// The host, or a copy, has written them; or they are garbage again.
void deviceWritten(void* pointer, size_t bytes);
void deviceForgotten(void* pointer, size_t bytes);

}  // namespace gw::stand_in
