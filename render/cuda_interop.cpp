#include "render/cuda_interop.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "render/cuda_objects.h"

namespace gw {
namespace {

// The draw command that a kernel writes lies in pinned host memory: 16 bytes over the bus. So when the writer has
// finished the host knows how many live, and copies just those, without a read-back to wait for and without moving a
// whole capacity that may be a hundred times as large.
uint32_t instancesIn(const DrawArraysCommand& command, uint32_t capacity) {
  return std::min(command.instanceCount, capacity);
}

// Kernels write staging buffers; the draw stream copies them into OpenGL's own.
template <class Vertex>
class SharedStream final : public Stream<Vertex> {
 public:
  explicit SharedStream(uint32_t capacity)
      : capacity_(capacity),
        commands_(makeGlBuffer(sizeof(DrawArraysCommand) * this->kRegions, nullptr, GL_DYNAMIC_STORAGE_BIT)),
        h_commands_(allocatePinned<DrawArraysCommand>(this->kRegions)),
        drawStream_(makeCudaQueue()) {
    for (Region& region : regions_) {
      region.d_staging = allocateDevice<Vertex>(capacity);
      region.vertices = makeGlBuffer(size_t(capacity) * sizeof(Vertex), nullptr, 0);
      region.shared = shareWithCuda(region.vertices);
      region.copied = makeCudaEvent();
    }
  }

  ~SharedStream() override {
    cudaStreamSynchronize(drawStream_.get());  // the last copies still use what goes now
  }

  RegionOf<Vertex> begin() override {
    current_ = (current_ + 1) % this->kRegions;
    Region& region = regions_[current_];
    check(cudaEventSynchronize(region.copied.get()), "waiting for an earlier frame's sprites");
    command() = this->kDrawNothing;
    RegionOf<Vertex> out;
    out.vertices = region.d_staging.get();
    out.capacity = capacity_;
    out.command = &command();
    out.vertexBuffer = region.vertices.get();
    out.commandBuffer = commands_.get();
    out.commandOffset_bytes = current_ * sizeof(DrawArraysCommand);
    return out;
  }

  void written() override {
    command().instanceCount = instancesIn(command(), capacity_);
    if (command().instanceCount > 0) copy(regions_[current_], command().instanceCount);
    glNamedBufferSubData(commands_.get(), GLintptr(current_ * sizeof(DrawArraysCommand)), sizeof(DrawArraysCommand),
                         &command());
    checkGl("handing over the sprites");
  }

  void end() override {}  // the next map of this region waits by itself

 private:
  struct Region {
    DeviceArray<Vertex> d_staging;
    GlBuffer vertices;
    CudaOwner<cudaGraphicsResource_t> shared;  // after the buffer: goes before it
    CudaOwner<cudaEvent_t> copied;
  };

  DrawArraysCommand& command() { return h_commands_.get()[current_]; }

  void copy(const Region& region, uint32_t count) {
    MappedResource mapped(region.shared.get(), drawStream_.get());
    check(cudaMemcpyAsync(mapped.address(), region.d_staging.get(), size_t(count) * sizeof(Vertex),
                          cudaMemcpyDeviceToDevice, drawStream_.get()),
          "copying the sprites");
    mapped.unmap();
    check(cudaEventRecord(region.copied.get(), drawStream_.get()), "copying the sprites");
  }

  uint32_t capacity_;
  GlBuffer commands_;
  PinnedArray<DrawArraysCommand> h_commands_;
  CudaOwner<cudaStream_t> drawStream_;
  std::array<Region, Stream<Vertex>::kRegions> regions_;
  uint32_t current_ = Stream<Vertex>::kRegions - 1;
};

// OpenGL draws on another device: what lives goes through pinned memory into the maps of an ordinary MappedStream. The
// host waits for that copy, which waits for no frame; so one staging buffer is enough.
template <class Vertex>
class CopiedStream final : public Stream<Vertex> {
 public:
  explicit CopiedStream(uint32_t capacity)
      : host_(capacity),
        d_staging_(allocateDevice<Vertex>(capacity)),
        h_vertices_(allocatePinned<Vertex>(capacity)),
        h_command_(allocatePinned<DrawArraysCommand>(1)),
        copyStream_(makeCudaQueue()) {}

  RegionOf<Vertex> begin() override {
    region_ = host_.begin();
    *h_command_ = this->kDrawNothing;
    RegionOf<Vertex> out = region_;
    out.vertices = d_staging_.get();
    out.command = h_command_.get();
    return out;
  }

  void written() override {
    DrawArraysCommand command = *h_command_;
    command.instanceCount = instancesIn(command, region_.capacity);
    const size_t bytes = size_t(command.instanceCount) * sizeof(Vertex);
    if (bytes > 0) {
      check(cudaMemcpyAsync(h_vertices_.get(), d_staging_.get(), bytes, cudaMemcpyDeviceToHost, copyStream_.get()),
            "copying the sprites");
      check(cudaStreamSynchronize(copyStream_.get()), "copying the sprites");
      std::memcpy(region_.vertices, h_vertices_.get(), bytes);
    }
    *region_.command = command;
    host_.written();
  }

  void end() override { host_.end(); }

 private:
  MappedStream<Vertex> host_;
  RegionOf<Vertex> region_;
  DeviceArray<Vertex> d_staging_;
  PinnedArray<Vertex> h_vertices_;
  PinnedArray<DrawArraysCommand> h_command_;
  CudaOwner<cudaStream_t> copyStream_;
};

// Why the current context cannot share memory with the current CUDA device; empty when it can.
std::string whyNotShared() {
  int current = 0;
  check(cudaGetDevice(&current), "asking for the device");
  unsigned count = 0;
  std::array<int, 16> devices{};
  if (cudaGLGetDevices(&count, devices.data(), unsigned(devices.size()), cudaGLDeviceListAll) != cudaSuccess) {
    cudaGetLastError();  // a context of another vendor answers with an error: it is an answer, not a failure to keep
    count = 0;
  }
  const auto end = devices.begin() + std::min<size_t>(count, devices.size());
  if (std::find(devices.begin(), end, current) == end) {
    return std::string("OpenGL draws with ") + reinterpret_cast<const char*>(glGetString(GL_RENDERER)) +
           ", which is not the CUDA device";
  }
  // The right GPU may refuse all the same, as a slice of one does.
  const GlBuffer trial = makeGlBuffer(sizeof(DrawArraysCommand), nullptr, 0);
  cudaGraphicsResource_t resource = nullptr;
  const cudaError_t result =
      cudaGraphicsGLRegisterBuffer(&resource, trial.get(), cudaGraphicsRegisterFlagsWriteDiscard);
  if (result == cudaSuccess) {
    cudaGraphicsUnregisterResource(resource);
    return "";
  }
  cudaGetLastError();
  return std::string("CUDA refuses OpenGL's memory (") + cudaGetErrorString(result) + ")";
}

}  // namespace

template <class Vertex>
CudaStream<Vertex> makeCudaStream(uint32_t capacity, Sharing sharing) {
  std::string why = sharing == Sharing::never ? "it was not asked for" : whyNotShared();
  if (why.empty()) return {std::make_unique<SharedStream<Vertex>>(capacity), true, ""};
  return {std::make_unique<CopiedStream<Vertex>>(capacity), false, std::move(why)};
}

template CudaStream<SpriteVertex> makeCudaStream(uint32_t capacity, Sharing sharing);
template CudaStream<ParticleVertex> makeCudaStream(uint32_t capacity, Sharing sharing);

}  // namespace gw
