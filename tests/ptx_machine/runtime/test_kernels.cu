#include "tests/ptx_machine/runtime/test_kernels.h"

namespace gw::ptx {
namespace {

__global__ void mixedKernel(float* out, const float* in, char small, Mixed mixed, uint32_t count, float factor) {
  const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < count) out[i] = in[i] * factor + float(mixed.large) + float(small) + float(mixed.pair[2]);
}

extern __shared__ uint32_t s_values[];

__global__ void sumsKernel(uint32_t* out) {
  __shared__ uint32_t s_sum;
  s_values[threadIdx.x] = threadIdx.x;
  if (threadIdx.x == 0) s_sum = 0;
  __syncthreads();
  atomicAdd(&s_sum, s_values[blockDim.x - 1 - threadIdx.x]);
  __syncthreads();
  if (threadIdx.x == 0) out[blockIdx.x] = s_sum;
}

__global__ void placesKernel(uint32_t* out) {
  const uint32_t x = blockIdx.x * blockDim.x + threadIdx.x, y = blockIdx.y * blockDim.y + threadIdx.y,
                 z = blockIdx.z * blockDim.z + threadIdx.z;
  const uint32_t width = gridDim.x * blockDim.x, height = gridDim.y * blockDim.y;
  out[x + width * (y + height * z)] = x + 100 * y + 10000 * z;
}

__global__ void offByOneKernel(uint32_t* out, uint32_t count) {
  const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i <= count) out[i] = i;  // the planted fault
}

__device__ uint32_t counter = 40;

__global__ void counterKernel(uint32_t* out) {
  *out = atomicAdd(&counter, 1u) + 1;
}

cudaLaunchConfig_t configOf(dim3 grid, dim3 block, size_t shared_bytes, cudaStream_t stream) {
  cudaLaunchConfig_t config{};
  config.gridDim = grid;
  config.blockDim = block;
  config.dynamicSmemBytes = shared_bytes;
  config.stream = stream;
  return config;
}

constexpr uint32_t kThreads = 64;

}  // namespace

void launchMixed(float* d_out, const float* d_in, char small, Mixed mixed, uint32_t count, float factor,
                 cudaStream_t stream) {
  mixedKernel<<<(count + kThreads - 1) / kThreads, kThreads, 0, stream>>>(d_out, d_in, small, mixed, count, factor);
}

cudaError_t launchMixedEx(float* d_out, const float* d_in, char small, Mixed mixed, uint32_t count, float factor,
                          cudaStream_t stream) {
  const cudaLaunchConfig_t config = configOf((count + kThreads - 1) / kThreads, kThreads, 0, stream);
  return cudaLaunchKernelEx(&config, mixedKernel, d_out, d_in, small, mixed, count, factor);
}

cudaError_t launchSums(uint32_t* d_out, uint32_t blocks, uint32_t threads, size_t dynamicShared_bytes,
                       cudaStream_t stream) {
  const cudaLaunchConfig_t config = configOf(blocks, threads, dynamicShared_bytes, stream);
  return cudaLaunchKernelEx(&config, sumsKernel, d_out);
}

cudaError_t launchPlaces(uint32_t* d_out, dim3 grid, dim3 block, cudaStream_t stream) {
  const cudaLaunchConfig_t config = configOf(grid, block, 0, stream);
  return cudaLaunchKernelEx(&config, placesKernel, d_out);
}

cudaError_t launchOffByOne(uint32_t* d_out, uint32_t count, cudaStream_t stream) {
  const cudaLaunchConfig_t config = configOf((count + kThreads) / kThreads, kThreads, 0, stream);
  return cudaLaunchKernelEx(&config, offByOneKernel, d_out, count);
}

cudaError_t launchCounter(uint32_t* d_out, cudaStream_t stream) {
  const cudaLaunchConfig_t config = configOf(1, 1, 0, stream);
  return cudaLaunchKernelEx(&config, counterKernel, d_out);
}

const void* sumsStub() {
  return reinterpret_cast<const void*>(sumsKernel);
}

uint32_t* allocateWords(size_t count) {
  uint32_t* d_words = nullptr;
  return cudaMalloc(&d_words, count * sizeof(uint32_t)) == cudaSuccess ? d_words : nullptr;
}

}  // namespace gw::ptx
