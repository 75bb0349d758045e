// Sprites and particles written by CUDA kernels straight into OpenGL's buffers. Same use as MappedStream; the addresses
// in a region are device addresses. Only in builds with CUDA.
//
// Never run so far: compiled and read only, for want of a machine with a GPU and OpenGL on it. What must hold
// there: a frame drawn from this stream equals the one that MappedStream draws from the same vertices.
#pragma once

#include <memory>
#include <string>

#include "render/vertex_stream.h"

namespace gw {

template <class Vertex>
struct CudaStream {
  std::unique_ptr<Stream<Vertex>> stream;
  bool shared;      // true: kernels write OpenGL's own memory; false: one copy through the host per frame
  std::string why;  // when not shared: why, in a few words
};

// Shares memory when the current context draws on the current CUDA device. When it draws elsewhere (Mesa's
// llvmpipe, another card) kernels write a buffer of their own and written() copies the living part over.
template <class Vertex>
CudaStream<Vertex> makeCudaStream(uint32_t capacity);

}  // namespace gw
