// Every call of the CUDA runtime passes through check(): what fails is thrown, as a sentence with a remedy.
// Not for users: include <gpuwars/exec.h>, which has it on the cuda device.
#pragma once

#include <cuda_runtime_api.h>
#include <gpuwars/device_error.h>

#include <string>

namespace gw {

// What to do about it, as the end of a sentence.
inline const char* cudaRemedy(cudaError_t error) {
  switch (error) {
    case cudaErrorMemoryAllocation:
      return "choose a smaller --enemies, or --device cpu";
    case cudaErrorInsufficientDriver:
    case cudaErrorUnsupportedPtxVersion:
      return "update the NVIDIA driver, or choose --device cpu";
    case cudaErrorNoKernelImageForDevice:
      return "build GpuWars for this GPU's architecture (CMAKE_CUDA_ARCHITECTURES), or choose --device cpu";
    case cudaErrorECCUncorrectable:
      return "restart the machine, and choose --device cpu until then";
    default:
      return "choose --device cpu: it plays the same game";
  }
}

// `doing` goes on from "while": "allocating device memory".
inline void check(cudaError_t error, const char* doing) {
  if (error == cudaSuccess) return;
  cudaGetLastError();  // clear it: a caller that catches this and goes on must not get it again
  const std::string text =
      std::string("CUDA failed while ") + doing + " (" + cudaGetErrorString(error) + "): " + cudaRemedy(error) + ".";
  if (error == cudaErrorMemoryAllocation) throw DeviceOutOfMemory(text);
  throw DeviceError(text);
}

}  // namespace gw
