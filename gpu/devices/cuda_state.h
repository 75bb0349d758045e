// What the answers of a CUDA driver mean: whether this program can compute with it, and if not, what to do about it.
// Judged apart from asking (<gpuwars/device_list.h>), so that every case is tested where there is no driver.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gw {

// driverTooOld: for the CUDA runtime in this program. deviceTooOld: for its kernels. failed: the driver is there and
// has a fault of its own.
enum class CudaState { ready, notBuilt, noDriver, driverTooOld, noDevice, deviceTooOld, failed };
const char* nameOf(CudaState state);  // as the enumerator is called

// What a CUDA device says of itself.
struct CudaDevice {
  std::string name;      // e.g. "NVIDIA H200"
  int architecture = 0;  // compute capability, e.g. 90
};

// Versions as CUDA counts them: 13020 is 13.2. 0: none, or not known.
struct CudaAnswers {
  int driverVersion = 0;                              // the newest CUDA that the driver supports
  int runtimeVersion = 0;                             // the CUDA that this program was built with
  std::string driverRelease;                          // the driver's own, e.g. "580.65.06"
  int oldestArchitecture = 0;                         // that this program's kernels are compiled for
  bool insufficientDriver = false, noDevice = false;  // the two errors of the device count that mean something apart
  std::string error;                                  // any error's text; empty: none
  std::vector<CudaDevice> devices;                    // those that could be described; kernels run on the first
};

// What follows from the answers.
struct CudaVerdict {
  CudaState state = CudaState::ready;  // the first reason found
  std::string why;                     // one sentence with a remedy; empty when ready
};
// Never throws.
CudaVerdict judgeCuda(const CudaAnswers& answers);

// Why kernels cannot run on this device; empty when they can.
std::string tooOld(const CudaDevice& device, int oldestArchitecture);

// "13.2" of 13020.
std::string cudaVersionText(int version);

// The smallest of CMake's list of architectures, e.g. 75 of "80,75-real,90a,120-virtual"; 0 when none is a number
// ("native", "all-major"): then no device is refused in advance.
int oldestOf(std::string_view architectures);

// The release in the text of /proc/driver/nvidia/version; empty when there is none.
std::string driverReleaseIn(std::string_view text);

}  // namespace gw
