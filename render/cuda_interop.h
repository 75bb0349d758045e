// Sprites written by CUDA kernels straight into OpenGL's buffers. Same use as VertexStream; the addresses
// in StreamRegion are device addresses. Only in builds with CUDA.
//
// Not exercised by the test-suite of a machine without a GPU: there it is compiled only. What must hold on
// a machine with one: tests/render's stream tests pass with this stream in place of VertexStream.
#pragma once

#include <memory>
#include <string>

#include "render/vertex_stream.h"

namespace gw {

struct CudaStream {
  std::unique_ptr<SpriteStream> stream;
  bool shared;      // true: kernels write OpenGL's own memory; false: one copy through the host per frame
  std::string why;  // when not shared: why, in a few words
};

// Shares memory when the current context draws on the current CUDA device. When it draws elsewhere (Mesa's
// llvmpipe, another card) kernels write a buffer of their own and written() copies the living part over.
CudaStream makeCudaSpriteStream(uint32_t capacity);

}  // namespace gw
