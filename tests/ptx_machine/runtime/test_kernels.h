// Kernels for runtime_test.cpp, and their launches, as nvcc compiles both.
#pragma once

#include <cuda_runtime_api.h>

#include <cstdint>

namespace gw::ptx {

// Of several sizes and alignments: where each stands in the parameter block is nvcc's to say.
struct Mixed {
  char small;
  double large;
  uint16_t pair[3];
};

// d_out[i] = d_in[i] * factor + mixed.large + small + mixed.pair[2], for i < count; by <<<>>>.
void launchMixed(float* d_out, const float* d_in, char small, Mixed mixed, uint32_t count, float factor,
                 cudaStream_t stream);
// The same kernel by cudaLaunchKernelEx.
cudaError_t launchMixedEx(float* d_out, const float* d_in, char small, Mixed mixed, uint32_t count, float factor,
                          cudaStream_t stream);
// d_out[b] = the sum of block b's `threads` values 0, 1, ..., through static and dynamic shared memory.
cudaError_t launchSums(uint32_t* d_out, uint32_t blocks, uint32_t threads, size_t dynamicShared_bytes,
                       cudaStream_t stream);
// d_out[thread] = its place in the grid of three dimensions, as x + 100 y + 10000 z.
cudaError_t launchPlaces(uint32_t* d_out, dim3 grid, dim3 block, cudaStream_t stream);
// Writes d_out[count], one too many.
cudaError_t launchOffByOne(uint32_t* d_out, uint32_t count, cudaStream_t stream);
// Adds to a variable of the module that begins as 40, and tells it in *d_out.
cudaError_t launchCounter(uint32_t* d_out, cudaStream_t stream);

const void* sumsStub();

// In a file that is compiled as those of gpu/ are: a fault says that this is where its memory was made.
uint32_t* allocateWords(size_t count);

}  // namespace gw::ptx
