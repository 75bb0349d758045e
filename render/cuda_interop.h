// Sprites and particles that CUDA kernels write, on their way to OpenGL. Same use as MappedStream; the addresses in a
// region are such that kernels can write there. Only in builds with CUDA.
//
//   tick's stream  ==ticks==  draw list -> staging[r] |            ==ticks==        never meets OpenGL
//   draw stream                                       | map GL[r], copy what lives, unmap, event[r]
//   OpenGL         ...frame n-1                       |                             draws GL[r]
//
// cudaGraphicsMapResources lets no later work of its stream begin before all earlier GL commands are done. On a stream
// of the simulation's, or on the default one, ticks would wait for frames; so mapping has a stream of its own, and
// kernels never write OpenGL's memory but a staging buffer, from which it is copied on the device. begin() waits for
// the copy made three frames ago.
#pragma once

#include <memory>
#include <string>

#include "render/vertex_stream.h"

namespace gw {

template <class Vertex>
struct CudaStream {
  std::unique_ptr<Stream<Vertex>> stream;
  bool shared = false;  // true: a frame stays on the device; false: it goes through the host
  std::string why;      // when not shared: why, as part of a sentence
};

enum class Sharing { wherePossible, never };

// Shares memory when the current context draws on the current CUDA device. Where it draws elsewhere (Mesa's llvmpipe,
// another card) written() copies what lives through pinned memory.
// Between begin() and written() the writer must have finished: kernels queued and waited for. Every CUDA error is a
// DeviceError; the stream is then good for nothing but its destructor.
template <class Vertex>
CudaStream<Vertex> makeCudaStream(uint32_t capacity, Sharing sharing = Sharing::wherePossible);

}  // namespace gw
