#include "render/cuda_interop.h"

// Before CUDA's: its header would otherwise pull in the system's gl.h, which GLEW refuses to follow.
#include <GL/glew.h>
#include <cuda_gl_interop.h>
#include <cuda_runtime_api.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace gw {
namespace {

void checkCuda(cudaError_t result, const char* doing) {
  if (result == cudaSuccess) return;
  throw std::runtime_error(std::string("CUDA failed while ") + doing + " (" + cudaGetErrorString(result) +
                           "): update the NVIDIA driver, or run with --device cpu.");
}

// Kernels write OpenGL's own buffers. Mapping orders the two sides: GL commands issued before the map are
// finished before CUDA writes, and CUDA's writes before the GL commands issued after the unmap. So one
// region is enough, and there are no fences.
template <class Vertex>
class SharedStream final : public Stream<Vertex> {
 public:
  explicit SharedStream(uint32_t capacity)
      : capacity_(capacity),
        vertices_(makeGlBuffer(size_t(capacity) * sizeof(Vertex), nullptr, 0)),
        command_(makeGlBuffer(sizeof(DrawArraysCommand), &this->kDrawNothing, 0)) {
    // WriteDiscard only where every frame writes all that is drawn: begin() copies the command, and may read it.
    registerBuffer(0, vertices_.get(), cudaGraphicsRegisterFlagsWriteDiscard);
    registerBuffer(1, command_.get(), cudaGraphicsRegisterFlagsNone);
  }

  ~SharedStream() override {
    if (mapped_) cudaGraphicsUnmapResources(GLsizei(resources_.size()), resources_.data(), nullptr);
    for (cudaGraphicsResource_t resource : resources_) {
      if (resource != nullptr) cudaGraphicsUnregisterResource(resource);
    }
  }

  RegionOf<Vertex> begin() override {
    checkCuda(cudaGraphicsMapResources(int(resources_.size()), resources_.data(), nullptr), "mapping the sprites");
    mapped_ = true;
    RegionOf<Vertex> region;
    size_t vertices_bytes = 0, command_bytes = 0;
    void* d_vertices = nullptr;
    void* d_command = nullptr;
    checkCuda(cudaGraphicsResourceGetMappedPointer(&d_vertices, &vertices_bytes, resources_[0]), "mapping the sprites");
    checkCuda(cudaGraphicsResourceGetMappedPointer(&d_command, &command_bytes, resources_[1]), "mapping the sprites");
    checkCuda(
        cudaMemcpyAsync(d_command, &this->kDrawNothing, sizeof(DrawArraysCommand), cudaMemcpyHostToDevice, nullptr),
        "clearing the draw command");
    // The map is ordered before work in the default stream only; the simulation's own stream does not know of it.
    checkCuda(cudaStreamSynchronize(nullptr), "mapping the sprites");
    region.vertices = static_cast<Vertex*>(d_vertices);
    region.capacity = std::min(capacity_, uint32_t(vertices_bytes / sizeof(Vertex)));
    region.command = static_cast<DrawArraysCommand*>(d_command);
    region.vertexBuffer = vertices_.get();
    region.commandBuffer = command_.get();
    return region;
  }

  void written() override {
    // Whatever stream the writer used. A tick takes well under a millisecond, so a whole device wait is no loss.
    checkCuda(cudaDeviceSynchronize(), "writing the sprites");
    mapped_ = false;
    checkCuda(cudaGraphicsUnmapResources(int(resources_.size()), resources_.data(), nullptr),
              "handing over the sprites");
  }

  void end() override {}  // the next map waits by itself

 private:
  void registerBuffer(size_t which, GLuint buffer, unsigned flags) {
    const cudaError_t result = cudaGraphicsGLRegisterBuffer(&resources_[which], buffer, flags);
    if (result == cudaSuccess) return;
    resources_[which] = nullptr;
    for (cudaGraphicsResource_t resource : resources_) {
      if (resource != nullptr) cudaGraphicsUnregisterResource(resource);
    }
    checkCuda(result, "sharing the sprites with OpenGL");
  }

  uint32_t capacity_;
  GlBuffer vertices_, command_;
  std::array<cudaGraphicsResource_t, 2> resources_{};
  bool mapped_ = false;
};

struct FreeDevice {
  void operator()(void* d_memory) const { cudaFree(d_memory); }
};

template <class T>
std::unique_ptr<T, FreeDevice> allocateDevice(size_t count) {
  void* d_memory = nullptr;
  checkCuda(cudaMalloc(&d_memory, count * sizeof(T)), "making room for the sprites");
  return std::unique_ptr<T, FreeDevice>(static_cast<T*>(d_memory));
}

// OpenGL draws on another device: kernels write a buffer of their own, and what lives of it is copied into
// the persistent maps of an ordinary VertexStream.
template <class Vertex>
class CopiedStream final : public Stream<Vertex> {
 public:
  explicit CopiedStream(uint32_t capacity)
      : host_(capacity),
        d_vertices_(allocateDevice<Vertex>(capacity)),
        d_command_(allocateDevice<DrawArraysCommand>(1)) {}

  RegionOf<Vertex> begin() override {
    checkCuda(cudaMemcpy(d_command_.get(), &this->kDrawNothing, sizeof(DrawArraysCommand), cudaMemcpyHostToDevice),
              "clearing the draw command");
    region_ = host_.begin();
    RegionOf<Vertex> region = region_;
    region.vertices = d_vertices_.get();
    region.command = d_command_.get();
    return region;
  }

  void written() override {
    checkCuda(cudaDeviceSynchronize(), "writing the sprites");
    DrawArraysCommand command;
    checkCuda(cudaMemcpy(&command, d_command_.get(), sizeof command, cudaMemcpyDeviceToHost), "copying the sprites");
    command.instanceCount = std::min(command.instanceCount, region_.capacity);
    checkCuda(cudaMemcpy(region_.vertices, d_vertices_.get(), size_t(command.instanceCount) * sizeof(Vertex),
                         cudaMemcpyDeviceToHost),
              "copying the sprites");
    *region_.command = command;
    host_.written();
  }

  void end() override { host_.end(); }

 private:
  MappedStream<Vertex> host_;
  RegionOf<Vertex> region_;
  std::unique_ptr<Vertex, FreeDevice> d_vertices_;
  std::unique_ptr<DrawArraysCommand, FreeDevice> d_command_;
};

// Why the current context cannot share memory with the current CUDA device; empty when it can.
std::string whyNotShared() {
  int current = 0;
  checkCuda(cudaGetDevice(&current), "asking for the device");
  unsigned count = 0;
  std::array<int, 16> devices{};
  const cudaError_t result = cudaGLGetDevices(&count, devices.data(), unsigned(devices.size()), cudaGLDeviceListAll);
  if (result != cudaSuccess) {
    cudaGetLastError();  // a context of another vendor answers with an error: it is an answer, not a failure to keep
    return "OpenGL does not draw on an NVIDIA GPU";
  }
  const auto end = devices.begin() + std::min<size_t>(count, devices.size());
  return std::find(devices.begin(), end, current) == end ? "OpenGL draws on another GPU" : "";
}

}  // namespace

template <class Vertex>
CudaStream<Vertex> makeCudaStream(uint32_t capacity) {
  std::string why = whyNotShared();
  if (why.empty()) return {std::make_unique<SharedStream<Vertex>>(capacity), true, ""};
  return {std::make_unique<CopiedStream<Vertex>>(capacity), false, std::move(why)};
}

template CudaStream<SpriteVertex> makeCudaStream(uint32_t capacity);
template CudaStream<ParticleVertex> makeCudaStream(uint32_t capacity);

}  // namespace gw
