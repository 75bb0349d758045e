// The execution layer on the cuda device. Include gpu/exec.h, not this.
#pragma once

#include <cuda_runtime.h>

#include <string>

#include "gpu/device_error.h"
#include "gpu/exec_options.h"

namespace gw::GW_DEVICE {

inline void check(cudaError_t error, const char* what) {
  if (error == cudaSuccess) return;
  cudaGetLastError();  // forget it: whoever catches this and goes on must not meet it again
  throw DeviceError(std::string("CUDA failed at ") + what + ": " + cudaGetErrorString(error) +
                    "; use the cpu device instead (in the game: --device cpu).");
}

class Queue {
 public:
  explicit Queue(const ExecOptions& options) : blockSize(options.blockSize) {
    check(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), "making a stream");
  }
  ~Queue() { cudaStreamDestroy(stream); }
  Queue(const Queue&) = delete;
  Queue& operator=(const Queue&) = delete;

  void synchronise() { check(cudaStreamSynchronize(stream), "waiting for the stream"); }

  cudaStream_t stream = nullptr;
  uint32_t blockSize;
};

// Launch errors show at once; what fails while running shows at the next synchronisation. Debug builds
// synchronise after every launch, except while the tick is being captured.
inline void checkLaunch(Queue& queue, const char* kernel) {
  check(cudaGetLastError(), kernel);
#ifndef NDEBUG
  cudaStreamCaptureStatus capturing = cudaStreamCaptureStatusNone;
  check(cudaStreamIsCapturing(queue.stream, &capturing), "asking whether the stream is captured");
  if (capturing == cudaStreamCaptureStatusNone) queue.synchronise();
#else
  (void)queue;
#endif
}

template <class Kernel>
__global__ void forEachKernel(const Kernel kernel, Count count) {
  const uint32_t n = count.d_live ? (*count.d_live < count.capacity ? *count.d_live : count.capacity) : count.capacity;
  const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < n) kernel(i);
}

template <class Kernel>
void forEach(Queue& queue, Count count, const Kernel& kernel) {
  if (count.capacity == 0) return;
  const uint32_t block = count.capacity < queue.blockSize ? count.capacity : queue.blockSize;
  forEachKernel<<<(count.capacity + block - 1) / block, block, 0, queue.stream>>>(kernel, count);
  checkLaunch(queue, "forEach");
}

template <uint32_t kLanes>
struct Team {
  uint32_t index;

  template <class Body>
  __device__ void phase(const Body& body) const {
    body(threadIdx.x);
    __syncthreads();
  }
};

template <class Kernel>
__global__ void forEachTeamKernel(const Kernel kernel) {
  extern __shared__ __align__(16) unsigned char raw[];
  kernel(Team<Kernel::kLanes>{blockIdx.x}, *reinterpret_cast<typename Kernel::Shared*>(raw));
}

template <class Kernel>
void forEachTeam(Queue& queue, uint32_t teams, const Kernel& kernel) {
  if (teams == 0) return;
  constexpr size_t kBytes = sizeof(typename Kernel::Shared), kWithoutAsking = 48 * 1024;
  if constexpr (kBytes > kWithoutAsking) {
    check(cudaFuncSetAttribute(forEachTeamKernel<Kernel>, cudaFuncAttributeMaxDynamicSharedMemorySize, int(kBytes)),
          "asking for shared memory");
  }
  forEachTeamKernel<<<teams, Kernel::kLanes, kBytes, queue.stream>>>(kernel);
  checkLaunch(queue, "forEachTeam");
}

enum class Copy { toDevice, toHost, onDevice };

// The one way in which bytes cross between host and device. Ordered on the queue; copies to the host
// have arrived when it returns.
inline void copyBytes(Queue& queue, void* destination, const void* source, size_t bytes, Copy kind) {
  if (bytes == 0) return;
  const cudaMemcpyKind kinds[] = {cudaMemcpyHostToDevice, cudaMemcpyDeviceToHost, cudaMemcpyDeviceToDevice};
  check(cudaMemcpyAsync(destination, source, bytes, kinds[int(kind)], queue.stream), "copying");
  if (kind == Copy::toHost) queue.synchronise();
}

inline void* allocateBytes(Queue& queue, size_t bytes) {
  void* pointer = nullptr;
  check(cudaMalloc(&pointer, bytes ? bytes : 1), "allocating device memory");
  check(cudaMemsetAsync(pointer, 0, bytes ? bytes : 1, queue.stream), "clearing device memory");
  return pointer;
}
inline void releaseBytes(Queue&, void* pointer) {
  cudaFree(pointer);
}

// Order-safe: integers only. They return nothing, so that no result can depend on who came first.
__device__ inline void atomicAddTo(uint32_t& word, uint32_t amount) {
  atomicAdd(&word, amount);
}
__device__ inline void atomicRaiseTo(uint64_t& word, uint64_t value) {
  atomicMax(reinterpret_cast<unsigned long long*>(&word), static_cast<unsigned long long>(value));
}
__device__ inline void atomicAddTo64(uint64_t& word, uint64_t amount) {
  atomicAdd(reinterpret_cast<unsigned long long*>(&word), static_cast<unsigned long long>(amount));
}

}  // namespace gw::GW_DEVICE
