// How sprites and particles reach OpenGL: a ring of three regions, so that the simulation fills one while the GPU still
// draws from the others.
//
//   begin()      waits until the GPU has drawn from the oldest region, and hands it out
//   (the draw-list kernel writes vertices and the instance count)
//   written()    the writer is done: from here OpenGL may read
//   draw(region, ...) of its pass   as often as wanted
//   end()        places the fence that begin() will wait for
#pragma once

#include <GL/glew.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "render/gl_objects.h"
#include "render/sprite_vertex.h"

namespace gw {

// One frame's worth of room. On the cpu device the pointers are mapped host memory: write in order, never
// read. On cuda they are device addresses.
template <class Vertex>
struct RegionOf {
  Vertex* vertices = nullptr;
  uint32_t capacity = 0;
  DrawArraysCommand* command = nullptr;  // begin() sets it to draw nothing; the writer sets instanceCount
  GLuint vertexBuffer = 0, commandBuffer = 0;
  size_t vertexOffset_bytes = 0, commandOffset_bytes = 0;
};

// What DrawArraysCommand::vertexCount must say: a sprite is a strip of four, a particle a triangle.
template <class Vertex>
inline constexpr uint32_t kInstanceVertices = 0;
template <>
inline constexpr uint32_t kInstanceVertices<SpriteVertex> = 4;
template <>
inline constexpr uint32_t kInstanceVertices<ParticleVertex> = 3;

template <class Vertex>
class Stream {
 public:
  static constexpr uint32_t kRegions = 3;
  static constexpr DrawArraysCommand kDrawNothing{kInstanceVertices<Vertex>, 0, 0, 0};

  virtual ~Stream() = default;
  virtual RegionOf<Vertex> begin() = 0;
  virtual void written() = 0;
  virtual void end() = 0;
};

// The ring in persistent, coherent host maps: the writer is the CPU.
template <class Vertex>
class MappedStream : public Stream<Vertex> {
 public:
  explicit MappedStream(uint32_t capacity);
  ~MappedStream() override;
  MappedStream(const MappedStream&) = delete;
  MappedStream& operator=(const MappedStream&) = delete;

  RegionOf<Vertex> begin() override;
  void written() override {}  // a coherent map needs nothing: later GL commands see earlier writes
  void end() override;

  // Times begin() found the GPU still busy with the region, since the start: the frame was bound by drawing.
  uint64_t waits() const { return waits_; }

 private:
  uint32_t capacity_;
  GlBuffer vertices_, commands_;
  Vertex* mappedVertices_ = nullptr;
  std::byte* mappedCommands_ = nullptr;
  std::array<GLsync, Stream<Vertex>::kRegions> fences_{};
  uint32_t region_ = Stream<Vertex>::kRegions - 1;
  uint64_t waits_ = 0;
};

using StreamRegion = RegionOf<SpriteVertex>;
using SpriteStream = Stream<SpriteVertex>;
using VertexStream = MappedStream<SpriteVertex>;
using ParticleRegion = RegionOf<ParticleVertex>;
using ParticleStream = Stream<ParticleVertex>;

}  // namespace gw
