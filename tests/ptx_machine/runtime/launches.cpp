// How kernels are launched: what nvcc's objects call, from the template cudaLaunchKernelEx and from <<<>>> to the work
// that is enqueued. Signatures: crt/device_functions.h, crt/host_runtime.h and cuda_runtime_api.h of the toolkit.
#include <cuda_runtime_api.h>

#include <vector>

#include "tests/fake_cuda/driver.h"
#include "tests/ptx_machine/runtime/registration.h"
#include "tests/ptx_machine/runtime/run_kernel.h"

using namespace gw::ptx;
using namespace gw::stand_in;

namespace {

constexpr unsigned kMostThreads = 1024, kThreadsOfMultiprocessor = 2048, kBlocksOfMultiprocessor = 32;
constexpr size_t kSharedOfMultiprocessor_bytes = 228 * 1024, kSharedOfSystem_bytes = 1024;  // the latter of each block

// Between <<<>>> and the stub that it calls.
struct Configuration {
  dim3 grid, block;
  size_t shared_bytes;
  cudaStream_t stream;
};
thread_local std::vector<Configuration> configurations;

bool isLaunchable(const Configuration& launch, const LoadedKernel& kernel) {
  const uint64_t threads = uint64_t(launch.block.x) * launch.block.y * launch.block.z;
  const uint32_t most = kernel.text->maxThreads ? kernel.text->maxThreads : kMostThreads;
  const bool hasBlocks = launch.grid.x > 0 && launch.grid.y > 0 && launch.grid.z > 0 && launch.grid.x < 1u << 31 &&
                         launch.grid.y < 1u << 16 && launch.grid.z < 1u << 16;
  return hasBlocks && threads > 0 && threads <= most && launch.block.z <= 64 &&
         kernel.text->shared_bytes + launch.shared_bytes <= dynamicSharedLimit_bytes(kernel.stub);
}

cudaError_t launchKernel(RegisteredKernel* registered, const Configuration& launch, void** arguments) {
  CUstream_st* on = streamOf(launch.stream);
  if (!on) return failed(cudaErrorInvalidResourceHandle);
  if (!registered) return failed(cudaErrorInvalidDeviceFunction);
  const LoadedKernel* kernel = load(*registered);
  if (!kernel) return failed(cudaErrorInvalidPtx);
  if (!isLaunchable(launch, *kernel)) return failed(cudaErrorInvalidConfiguration);
  enqueue(*on, kernelWork(*kernel, {launch.grid.x, launch.grid.y, launch.grid.z},
                          {launch.block.x, launch.block.y, launch.block.z}, uint32_t(launch.shared_bytes), arguments));
  return cudaSuccess;
}

}  // namespace

extern "C" {

unsigned __cudaPushCallConfiguration(dim3 grid, dim3 block, size_t shared_bytes, CUstream_st* stream) {
  configurations.push_back({grid, block, shared_bytes, stream});
  return 0;
}

cudaError_t __cudaPopCallConfiguration(dim3* grid, dim3* block, size_t* shared_bytes, void* stream) {
  if (configurations.empty()) return cudaErrorInvalidConfiguration;
  const Configuration last = configurations.back();
  configurations.pop_back();
  *grid = last.grid;
  *block = last.block;
  *shared_bytes = last.shared_bytes;
  *static_cast<cudaStream_t*>(stream) = last.stream;
  return cudaSuccess;
}

// A cudaKernel_t is one of our RegisteredKernel.
cudaError_t __cudaGetKernel(cudaKernel_t* kernel, const void* stub) {
  *kernel = reinterpret_cast<cudaKernel_t>(registeredKernel(stub));
  return *kernel ? cudaSuccess : cudaErrorInvalidDeviceFunction;
}

cudaError_t __cudaLaunchKernel(cudaKernel_t kernel, dim3 grid, dim3 block, void** arguments, size_t shared_bytes,
                               cudaStream_t stream) {
  GW_ENTER("cudaLaunchKernel");
  return launchKernel(reinterpret_cast<RegisteredKernel*>(kernel), {grid, block, shared_bytes, stream}, arguments);
}

}  // extern "C"

cudaError_t cudaLaunchKernel(const void* stub, dim3 grid, dim3 block, void** arguments, size_t shared_bytes,
                             cudaStream_t stream) {
  GW_ENTER("cudaLaunchKernel");
  return launchKernel(registeredKernel(stub), {grid, block, shared_bytes, stream}, arguments);
}

cudaError_t cudaLaunchKernelExC(const cudaLaunchConfig_t* config, const void* stub, void** arguments) {
  GW_ENTER("cudaLaunchKernelEx");
  if (config->numAttrs != 0)
    return failed(cudaErrorNotSupported);  // clusters and the like, which nothing here asks for
  return launchKernel(registeredKernel(stub),
                      {config->gridDim, config->blockDim, config->dynamicSmemBytes, config->stream}, arguments);
}

cudaError_t cudaFuncSetAttribute(const void* stub, cudaFuncAttribute attribute, int value) {
  GW_ENTER("cudaFuncSetAttribute");
  if (!registeredKernel(stub)) return failed(cudaErrorInvalidDeviceFunction);
  if (attribute != cudaFuncAttributeMaxDynamicSharedMemorySize) return failed(cudaErrorNotSupported);
  if (value < 0 || value > 227 * 1024) return failed(cudaErrorInvalidValue);
  driver().sharedLimits[stub] = value;
  return cudaSuccess;
}

cudaError_t cudaFuncGetAttributes(cudaFuncAttributes* attributes, const void* stub) {
  GW_ENTER("cudaFuncGetAttributes");
  RegisteredKernel* registered = registeredKernel(stub);
  if (!registered) return failed(cudaErrorInvalidDeviceFunction);
  const LoadedKernel* kernel = load(*registered);
  if (!kernel) return failed(cudaErrorInvalidPtx);
  *attributes = {};
  attributes->sharedSizeBytes = kernel->text->shared_bytes;
  attributes->localSizeBytes = kernel->text->local_bytes;
  attributes->maxThreadsPerBlock = int(kernel->text->maxThreads ? kernel->text->maxThreads : kMostThreads);
  attributes->numRegs = 32;  // ptxas would say
  attributes->ptxVersion = attributes->binaryVersion = deviceArchitecture();
  attributes->maxDynamicSharedSizeBytes = int(dynamicSharedLimit_bytes(stub));
  return cudaSuccess;
}

cudaError_t cudaOccupancyMaxActiveBlocksPerMultiprocessorWithFlags(int* blocks, const void* stub, int threads,
                                                                   size_t dynamicShared_bytes, unsigned) {
  GW_ENTER("cudaOccupancyMaxActiveBlocksPerMultiprocessor");
  RegisteredKernel* registered = registeredKernel(stub);
  if (!registered) return failed(cudaErrorInvalidDeviceFunction);
  const LoadedKernel* kernel = load(*registered);
  if (!kernel) return failed(cudaErrorInvalidPtx);
  if (threads <= 0 || threads > int(kMostThreads)) return failed(cudaErrorInvalidValue);
  const size_t shared = kernel->text->shared_bytes + dynamicShared_bytes + kSharedOfSystem_bytes;
  const size_t byShared = kSharedOfMultiprocessor_bytes / shared;
  const unsigned warps = (unsigned(threads) + kLanes - 1) / kLanes,
                 byThreads = kThreadsOfMultiprocessor / (warps * kLanes);
  *blocks = int(std::min({size_t(byThreads), byShared, size_t(kBlocksOfMultiprocessor)}));
  return cudaSuccess;
}

cudaError_t cudaOccupancyMaxActiveBlocksPerMultiprocessor(int* blocks, const void* stub, int threads,
                                                          size_t dynamicShared_bytes) {
  return cudaOccupancyMaxActiveBlocksPerMultiprocessorWithFlags(blocks, stub, threads, dynamicShared_bytes, 0);
}
