// Writes sprites into a region as kernels do: by the device's addresses, finished when it returns.
#pragma once

#include <cuda_runtime_api.h>

#include <algorithm>
#include <vector>

#include "gpu/devices/cuda_check.h"
#include "render/vertex_stream.h"

namespace gw {

// The command counts all of them; those past the capacity are not written.
inline void writeOnCuda(const StreamRegion& region, const std::vector<SpriteVertex>& sprites) {
  DrawArraysCommand command = SpriteStream::kDrawNothing;
  command.instanceCount = uint32_t(sprites.size());
  const size_t fitting = std::min<size_t>(sprites.size(), region.capacity);
  check(cudaMemcpy(region.vertices, sprites.data(), fitting * sizeof(SpriteVertex), cudaMemcpyDefault), "writing");
  check(cudaMemcpy(region.command, &command, sizeof command, cudaMemcpyDefault), "writing");
}

}  // namespace gw
