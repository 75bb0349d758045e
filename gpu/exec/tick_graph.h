// A fixed sequence of launches, captured once and replayed every tick. On cuda a CUDA graph: one call per
// tick instead of one per launch. On cpu there is nothing to save, and replaying calls the sequence; so does a
// cuda queue that checks every launch.
// Captured pointers are frozen: code that ping-pongs buffers captures one graph per parity.
#pragma once

#include <gpuwars/exec.h>

#include <functional>
#include <utility>

namespace gw::GW_DEVICE {

// Its queue outlives it, and so does all that the launches point to. Move-only on cuda.
class TickGraph {
 public:
  TickGraph() = default;

#if GW_ON_CUDA
  TickGraph(Queue& queue, std::function<void()> launches) {
    if (queue.checksLaunches) {
      launches_ = std::move(launches);
      return;
    }
    check(cudaStreamBeginCapture(queue.stream, cudaStreamCaptureModeThreadLocal), "beginning to capture the tick");
    cudaGraph_t graph = nullptr;
    const uint64_t before = queue.pending;
    try {
      launches();
    } catch (...) {
      cudaStreamEndCapture(queue.stream, &graph);
      if (graph) cudaGraphDestroy(graph);
      queue.pending = before;
      throw;
    }
    kernels_ = queue.pending - before;
    queue.pending = before;  // captured, not run
    check(cudaStreamEndCapture(queue.stream, &graph), "capturing the tick");
    const cudaError_t made = cudaGraphInstantiate(&graph_, graph, 0);
    cudaGraphDestroy(graph);
    check(made, "instantiating the tick's graph");
    // Now, so that the first tick is not late.
    const cudaError_t uploaded = cudaGraphUpload(graph_, queue.stream);
    if (uploaded != cudaSuccess) cudaGraphExecDestroy(graph_);  // no destructor will
    check(uploaded, "uploading the tick's graph");
  }
  ~TickGraph() {
    if (graph_) cudaGraphExecDestroy(graph_);
  }
  TickGraph(TickGraph&& other) noexcept {
    swap(other);
  }
  TickGraph& operator=(TickGraph&& other) noexcept {
    swap(other);
    return *this;
  }

  void replay(Queue& queue) {
    if (launches_) return launches_();
    check(cudaGraphLaunch(graph_, queue.stream), "launching the tick's graph");
    queue.pending += kernels_;
  }

 private:
  void swap(TickGraph& other) noexcept {
    std::swap(graph_, other.graph_);
    std::swap(kernels_, other.kernels_);
    std::swap(launches_, other.launches_);
  }

  cudaGraphExec_t graph_ = nullptr;
  uint64_t kernels_ = 0;
#else
  // Captures what launches() launches: on cuda it is called once, now, and what it does on the host is not repeated.
  // Throws DeviceError when something in it cannot be captured.
  TickGraph(Queue&, std::function<void()> launches) : launches_(std::move(launches)) {}

  // Queues all launches once more.
  void replay(Queue&) {
    launches_();
  }

 private:
#endif
  std::function<void()> launches_;
};

}  // namespace gw::GW_DEVICE
