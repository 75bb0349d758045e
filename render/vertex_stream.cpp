#include "render/vertex_stream.h"

#include <stdexcept>
#include <string>

namespace gw {
namespace {

constexpr GLbitfield kMapFlags = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;

// Commands of different regions share no cache line, so that the writer of one never evicts what the GPU reads.
constexpr size_t kCommandStride_bytes = 64;

constexpr GLuint64 kPatience_ns = 5'000'000'000;

}  // namespace

template <class Vertex>
MappedStream<Vertex>::MappedStream(uint32_t capacity) : capacity_(capacity) {
  const size_t vertices_bytes = size_t(capacity) * sizeof(Vertex) * this->kRegions;
  const size_t commands_bytes = kCommandStride_bytes * this->kRegions;
  vertices_ = makeGlBuffer(vertices_bytes, nullptr, kMapFlags);
  commands_ = makeGlBuffer(commands_bytes, nullptr, kMapFlags);
  mappedVertices_ =
      static_cast<Vertex*>(glMapNamedBufferRange(vertices_.get(), 0, GLsizeiptr(vertices_bytes), kMapFlags));
  mappedCommands_ =
      static_cast<std::byte*>(glMapNamedBufferRange(commands_.get(), 0, GLsizeiptr(commands_bytes), kMapFlags));
  if (mappedVertices_ == nullptr || mappedCommands_ == nullptr) {
    throw std::runtime_error("The graphics driver has no room for " + std::to_string(capacity) +
                             " sprites: choose a smaller --enemies.");
  }
}

template <class Vertex>
MappedStream<Vertex>::~MappedStream() {
  for (GLsync fence : fences_) glDeleteSync(fence);  // null is fine
}

template <class Vertex>
RegionOf<Vertex> MappedStream<Vertex>::begin() {
  region_ = (region_ + 1) % this->kRegions;
  GLsync& fence = fences_[region_];
  if (fence != nullptr) {
    GLenum state = glClientWaitSync(fence, 0, 0);
    if (state == GL_TIMEOUT_EXPIRED) {
      ++waits_;
      state = glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, kPatience_ns);
    }
    if (state == GL_TIMEOUT_EXPIRED || state == GL_WAIT_FAILED) {
      throw std::runtime_error(
          "The graphics driver did not finish a frame within 5 seconds: restart GpuWars, or run with "
          "a smaller window.");
    }
    glDeleteSync(fence);
    fence = nullptr;
  }

  RegionOf<Vertex> region;
  region.vertexOffset_bytes = size_t(region_) * capacity_ * sizeof(Vertex);
  region.commandOffset_bytes = region_ * kCommandStride_bytes;
  region.vertices = mappedVertices_ + size_t(region_) * capacity_;
  region.capacity = capacity_;
  region.command = reinterpret_cast<DrawArraysCommand*>(mappedCommands_ + region.commandOffset_bytes);
  region.vertexBuffer = vertices_.get();
  region.commandBuffer = commands_.get();
  *region.command = this->kDrawNothing;
  return region;
}

template <class Vertex>
void MappedStream<Vertex>::end() {
  glDeleteSync(fences_[region_]);
  fences_[region_] = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

template class MappedStream<SpriteVertex>;
template class MappedStream<ParticleVertex>;

}  // namespace gw
