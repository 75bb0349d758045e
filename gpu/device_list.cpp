#include "gpu/device_list.h"

#include <thread>

#ifdef GW_HAVE_CUDA
#include <cuda_runtime_api.h>
#endif

namespace gw {

DeviceList listDevices() {
  DeviceList list;
#ifdef GW_HAVE_CUDA
  int count = 0;
  const cudaError_t error = cudaGetDeviceCount(&count);
  if (error != cudaSuccess) {
    list.cudaMissing = std::string("No CUDA device answers (") + cudaGetErrorString(error) + ").";
  } else if (count == 0) {
    list.cudaMissing = "The CUDA driver is here but finds no device.";
  }
  for (int i = 0; error == cudaSuccess && i < count; ++i) {
    cudaDeviceProp properties{};
    if (cudaGetDeviceProperties(&properties, i) != cudaSuccess) continue;
    list.devices.push_back({"cuda", properties.name,
                            "sm_" + std::to_string(properties.major) + std::to_string(properties.minor) + ", " +
                                std::to_string(properties.totalGlobalMem >> 20) + " MiB"});
  }
  if (error == cudaSuccess && count > 0 && list.devices.empty()) {
    list.cudaMissing = "The CUDA driver lists devices but describes none.";
  }
#else
  list.cudaMissing = "This build has no cuda device (nvcc was not found when it was configured).";
#endif
  const unsigned threads = std::thread::hardware_concurrency();
  list.devices.push_back({"cpu", "worker pool", std::to_string(threads ? threads : 1) + " threads"});
  return list;
}

}  // namespace gw
