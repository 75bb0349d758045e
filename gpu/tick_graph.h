// A fixed sequence of launches, captured once and replayed every tick. On cuda a CUDA graph: one call per
// tick instead of one per launch. On cpu there is nothing to save, and replaying calls the sequence.
// Captured pointers are frozen: whoever ping-pongs buffers captures one graph per parity.
#pragma once

#include <functional>
#include <utility>

#include "gpu/exec.h"

namespace gw::GW_DEVICE {

class TickGraph {
 public:
  TickGraph() = default;

#if GW_ON_CUDA
  TickGraph(Queue& queue, const std::function<void()>& launches) {
    check(cudaStreamBeginCapture(queue.stream, cudaStreamCaptureModeThreadLocal), "beginning to capture the tick");
    launches();
    cudaGraph_t graph = nullptr;
    check(cudaStreamEndCapture(queue.stream, &graph), "capturing the tick");
    const cudaError_t made = cudaGraphInstantiate(&graph_, graph, 0);
    cudaGraphDestroy(graph);
    check(made, "instantiating the tick's graph");
  }
  ~TickGraph() {
    if (graph_) cudaGraphExecDestroy(graph_);
  }
  TickGraph(TickGraph&& other) noexcept {
    std::swap(graph_, other.graph_);
  }
  TickGraph& operator=(TickGraph&& other) noexcept {
    std::swap(graph_, other.graph_);
    return *this;
  }

  void replay(Queue& queue) {
    check(cudaGraphLaunch(graph_, queue.stream), "launching the tick's graph");
  }

 private:
  cudaGraphExec_t graph_ = nullptr;
#else
  TickGraph(Queue&, std::function<void()> launches) : launches_(std::move(launches)) {}

  void replay(Queue&) {
    launches_();
  }

 private:
  std::function<void()> launches_;
#endif
};

}  // namespace gw::GW_DEVICE
