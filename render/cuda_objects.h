// Owners of what the CUDA runtime hands out: move-only, given back with the owner. Giving back ignores errors: the CUDA
// context may be dead by then, and with it everything it held. Only in builds with CUDA.
#pragma once

// Before CUDA's: its header would otherwise pull in the system's gl.h, which GLEW refuses to follow.
#include <GL/glew.h>
#include <cuda_gl_interop.h>
#include <cuda_runtime_api.h>

#include <memory>
#include <type_traits>
#include <utility>

#include "gpu/devices/cuda_check.h"
#include "render/gl_objects.h"

namespace gw {

struct CudaRelease {
  void operator()(cudaStream_t stream) const { cudaStreamDestroy(stream); }
  void operator()(cudaEvent_t event) const { cudaEventDestroy(event); }
  void operator()(cudaGraphicsResource_t resource) const { cudaGraphicsUnregisterResource(resource); }
};
template <class Handle>
using CudaOwner = std::unique_ptr<std::remove_pointer_t<Handle>, CudaRelease>;

// A stream that waits for no other, the default stream included.
inline CudaOwner<cudaStream_t> makeCudaQueue() {
  cudaStream_t stream = nullptr;
  check(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), "making a stream");
  return CudaOwner<cudaStream_t>(stream);
}

inline CudaOwner<cudaEvent_t> makeCudaEvent() {
  cudaEvent_t event = nullptr;
  check(cudaEventCreateWithFlags(&event, cudaEventDisableTiming), "making an event");
  return CudaOwner<cudaEvent_t>(event);
}

// CUDA's view of an OpenGL buffer, which it only ever overwrites. Goes before the buffer does.
inline CudaOwner<cudaGraphicsResource_t> shareWithCuda(const GlBuffer& buffer) {
  cudaGraphicsResource_t resource = nullptr;
  check(cudaGraphicsGLRegisterBuffer(&resource, buffer.get(), cudaGraphicsRegisterFlagsWriteDiscard),
        "sharing the sprites with OpenGL");
  return CudaOwner<cudaGraphicsResource_t>(resource);
}

struct FreeDevice {
  void operator()(void* d_memory) const { cudaFree(d_memory); }
};
template <class T>
using DeviceArray = std::unique_ptr<T, FreeDevice>;

template <class T>
DeviceArray<T> allocateDevice(size_t count) {
  void* d_memory = nullptr;
  check(cudaMalloc(&d_memory, count * sizeof(T)), "making room for the sprites");
  return DeviceArray<T>(static_cast<T*>(d_memory));
}

// Host memory that copies need not stage, and that kernels reach by the same address.
struct FreePinned {
  void operator()(void* h_memory) const { cudaFreeHost(h_memory); }
};
template <class T>
using PinnedArray = std::unique_ptr<T, FreePinned>;

template <class T>
PinnedArray<T> allocatePinned(size_t count) {
  void* h_memory = nullptr;
  check(cudaMallocHost(&h_memory, count * sizeof(T)), "making room for the sprites");
  return PinnedArray<T>(static_cast<T*>(h_memory));
}

// One buffer of OpenGL's in CUDA's hands, for the work queued in between. Whatever throws there, it is given back.
class MappedResource {
 public:
  MappedResource(cudaGraphicsResource_t resource, cudaStream_t stream) : resource_(resource), stream_(stream) {
    check(cudaGraphicsMapResources(1, &resource_, stream_), "mapping the sprites");
    mapped_ = true;
  }
  ~MappedResource() {
    if (mapped_) cudaGraphicsUnmapResources(1, &resource_, stream_);
  }
  MappedResource(const MappedResource&) = delete;
  MappedResource& operator=(const MappedResource&) = delete;

  void* address() const {
    void* d_address = nullptr;
    size_t size_bytes = 0;
    check(cudaGraphicsResourceGetMappedPointer(&d_address, &size_bytes, resource_), "mapping the sprites");
    return d_address;
  }

  // The destructor does the same, but does not report a failure.
  void unmap() {
    check(cudaGraphicsUnmapResources(1, &resource_, stream_), "handing over the sprites");
    mapped_ = false;
  }

 private:
  cudaGraphicsResource_t resource_;
  cudaStream_t stream_;
  bool mapped_ = false;
};

}  // namespace gw
