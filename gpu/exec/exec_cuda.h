// The execution layer on the cuda device. Not for users: include <gpuwars/exec.h>.
#pragma once

#include <cuda_runtime.h>
#include <cxxabi.h>
#include <gpuwars/detail/cuda_check.h>
#include <gpuwars/exec_options.h>
#include <gpuwars/kernel_count.h>

#include <cstdlib>
#include <string>
#include <typeinfo>

namespace gw::GW_DEVICE {

using gw::check;

class Queue {
 public:
  explicit Queue(const ExecOptions& options) : blockSize(options.blockSize), checksLaunches(options.checkLaunches) {
    check(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), "making a stream");
  }
  ~Queue() {
    if (cudaStreamSynchronize(stream) == cudaSuccess) cudaKernelsRun += pending;
    cudaStreamDestroy(stream);
  }
  Queue(const Queue&) = delete;
  Queue& operator=(const Queue&) = delete;

  void synchronise() {
    check(cudaStreamSynchronize(stream), "waiting for the device");
    cudaKernelsRun += pending;
    pending = 0;
  }

  cudaStream_t stream = nullptr;
  uint32_t blockSize;
  bool checksLaunches;
  uint64_t launches = 0;  // so far; captured ones count once
  size_t bytes = 0;       // in its buffers, now
  uint64_t pending = 0;   // kernels that were to run since the queue was waited for; those of a graph at each replay
};

// As a person reads it: "gw::cuda::(anonymous namespace)::Integrate".
template <class Kernel>
std::string nameOfKernel() {
  int status = 0;
  char* text = abi::__cxa_demangle(typeid(Kernel).name(), nullptr, nullptr, &status);
  const std::string name = status == 0 ? text : typeid(Kernel).name();
  std::free(text);
  return name;
}

// Launch errors show at once; what fails while running shows at the next synchronisation, which is here when the queue
// checks launches: then it is known whose failure it is. Such a queue is never captured (TickGraph).
template <class Kernel, class... Parameters, class... Arguments>
void launch(Queue& queue, uint32_t blocks, uint32_t threads, size_t shared_bytes, void (*kernel)(Parameters...),
            const Arguments&... arguments) {
  cudaLaunchConfig_t config{};
  config.gridDim = dim3(blocks);
  config.blockDim = dim3(threads);
  config.dynamicSmemBytes = shared_bytes;
  config.stream = queue.stream;
  check(cudaLaunchKernelEx(&config, kernel, arguments...), "launching a kernel");
  ++queue.launches;
  ++queue.pending;
  if (!queue.checksLaunches) return;
  const cudaError_t ran = cudaStreamSynchronize(queue.stream);
  if (ran != cudaSuccess) check(ran, ("running the kernel " + nameOfKernel<Kernel>()).c_str());
}

template <class Kernel>
__global__ void forEachKernel(const Kernel kernel, const Count count) {
  const uint32_t n = count.d_live ? (*count.d_live < count.capacity ? *count.d_live : count.capacity) : count.capacity;
  const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < n) kernel(i);
}

template <class Kernel>
void forEach(Queue& queue, Count count, const Kernel& kernel) {
  if (count.capacity == 0) return;
  const uint32_t block = count.capacity < queue.blockSize ? count.capacity : queue.blockSize;
  launch<Kernel>(queue, (count.capacity + block - 1) / block, block, 0, forEachKernel<Kernel>, kernel, count);
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

// As many as the launch asks for.
extern __shared__ __align__(16) unsigned char sharedBytes[];

// The bound keeps to as many registers as one block of kLanes can have: without it a large team might not start.
template <class Kernel>
__global__ void __launch_bounds__(Kernel::kLanes, 1) forEachTeamKernel(const Kernel kernel) {
  kernel(Team<Kernel::kLanes>{blockIdx.x}, *reinterpret_cast<typename Kernel::Shared*>(sharedBytes));
}

template <class Kernel>
void forEachTeam(Queue& queue, uint32_t teams, const Kernel& kernel) {
  if (teams == 0) return;
  constexpr size_t kBytes = sizeof(typename Kernel::Shared), kWithoutAsking = 48 * 1024;
  if constexpr (kBytes > kWithoutAsking) {
    check(cudaFuncSetAttribute(forEachTeamKernel<Kernel>, cudaFuncAttributeMaxDynamicSharedMemorySize, int(kBytes)),
          "asking for shared memory");
  }
  launch<Kernel>(queue, teams, Kernel::kLanes, kBytes, forEachTeamKernel<Kernel>, kernel);
}

enum class Copy { toDevice, toHost, onDevice };

inline void enqueueCopy(Queue& queue, void* destination, const void* source, size_t bytes, Copy kind) {
  const cudaMemcpyKind kinds[] = {cudaMemcpyHostToDevice, cudaMemcpyDeviceToHost, cudaMemcpyDeviceToDevice};
  check(cudaMemcpyAsync(destination, source, bytes, kinds[int(kind)], queue.stream), "copying");
}

// The one way in which bytes cross between host and device. Ordered on the queue; copies to the host
// have arrived when it returns.
inline void copyBytes(Queue& queue, void* destination, const void* source, size_t bytes, Copy kind) {
  if (bytes == 0) return;
  enqueueCopy(queue, destination, source, bytes, kind);
  if (kind == Copy::toHost) queue.synchronise();
}

inline void* allocateBytes(Queue& queue, size_t bytes) {
  void* pointer = nullptr;
  check(cudaMalloc(&pointer, bytes ? bytes : 1), "allocating device memory");
  const cudaError_t cleared = cudaMemsetAsync(pointer, 0, bytes ? bytes : 1, queue.stream);
  if (cleared != cudaSuccess) cudaFree(pointer);
  check(cleared, "clearing device memory");
  return pointer;
}
inline void releaseBytes(Queue&, void* pointer) {
  cudaFree(pointer);
}

// Host memory that the device copies from and to by itself; it is lost with the device.
inline void* allocateHostBytes(Queue&, size_t bytes) {
  void* pointer = nullptr;
  check(cudaMallocHost(&pointer, bytes), "allocating pinned memory");
  return pointer;
}
inline void releaseHostBytes(Queue&, void* pointer) {
  cudaFreeHost(pointer);
}

// A place in the queue's work that the host can wait for.
class Fence {
 public:
  Fence() { check(cudaEventCreateWithFlags(&event_, cudaEventDisableTiming), "making an event"); }
  ~Fence() { cudaEventDestroy(event_); }
  Fence(const Fence&) = delete;
  Fence& operator=(const Fence&) = delete;

  void place(Queue& queue) { check(cudaEventRecord(event_, queue.stream), "recording an event"); }
  void wait() { check(cudaEventSynchronize(event_), "waiting for a tick"); }

 private:
  cudaEvent_t event_ = nullptr;
};

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
