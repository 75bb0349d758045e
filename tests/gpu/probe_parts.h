// How the probes' kernel files make up one table.
#pragma once

#include "gpu/exec/buffer.h"
#include "tests/gpu/probes.h"

namespace gw::GW_DEVICE {

void addExecProbes(test::Probes& probes);
void addMathProbes(test::Probes& probes);
void addScanProbes(test::Probes& probes);
void addGridProbes(test::Probes& probes);
void addGatherProbes(test::Probes& probes);

template <class T>
Buffer<T> uploaded(Queue& queue, const std::vector<T>& source) {
  Buffer<T> buffer(queue, source.size());
  buffer.upload(source);
  return buffer;
}

}  // namespace gw::GW_DEVICE
