// Time per named stage, in the order in which the stages first ran. On cpu a steady clock around the launches. On cuda,
// while a tick is captured, a pair of events around them, which are nodes of the graph: the device's own clock, read
// when the tick is done. Launches that are not captured are waited for, and timed by the host. Off, one branch.
// Each stage is a range for NVIDIA's profilers too. A listener is told after each stage that is not captured.
#pragma once

#include <gpuwars/exec.h>

#include <chrono>
#include <cstring>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#if GW_ON_CUDA
#include <nvtx3/nvToolsExt.h>
#endif

namespace gw::GW_DEVICE {

#if GW_ON_CUDA

// The events of one captured tick.
class StageMarks {
 public:
  StageMarks() = default;
  ~StageMarks() {
    for (const Span& span : spans_) {
      cudaEventDestroy(span.begin);
      cudaEventDestroy(span.end);
    }
  }
  StageMarks(StageMarks&& other) noexcept : spans_(std::exchange(other.spans_, {})) {}
  StageMarks& operator=(StageMarks&& other) noexcept {
    std::swap(spans_, other.spans_);
    return *this;
  }

 private:
  friend class StageTimer;
  struct Span {
    std::string stage;
    cudaEvent_t begin, end;
  };

  static void place(Queue& queue, cudaEvent_t& event) {
    if (event == nullptr) check(cudaEventCreateWithFlags(&event, cudaEventDefault), "making an event");
    check(cudaEventRecordWithFlags(event, queue.stream, cudaEventRecordExternal), "timing a stage");
  }

  std::vector<Span> spans_;
};

#else

struct StageMarks {};

#endif

// How long one launch takes, alone: waits for what came before and for itself. On cuda by the device's own clock, so
// without what the host takes to launch it; on cpu by a steady clock. Not while a tick is captured.
template <class Launch>
double timeAlone_ms(Queue& queue, const Launch& launch) {
  queue.synchronise();
#if GW_ON_CUDA
  struct Event {
    cudaEvent_t event = nullptr;
    Event() { check(cudaEventCreateWithFlags(&event, cudaEventDefault), "making an event"); }
    ~Event() { cudaEventDestroy(event); }
  } begin, end;
  check(cudaEventRecord(begin.event, queue.stream), "timing a launch");
  launch();
  check(cudaEventRecord(end.event, queue.stream), "timing a launch");
  queue.synchronise();
  float took_ms = 0;
  check(cudaEventElapsedTime(&took_ms, begin.event, end.event), "reading the time of a launch");
  return took_ms;
#else
  const auto begin = std::chrono::steady_clock::now();
  launch();
  queue.synchronise();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
#endif
}

// Sums the time of stages by name.
class StageTimer {
 public:
  // One stage so far.
  struct Stage {
    std::string name;     // as given to time()
    double total_ms = 0;  // of all calls
    uint64_t calls = 0;   // so far
  };

  // Off, time() only launches.
  void enable(bool on) { on_ = on; }
  // Whether stages are timed.
  bool enabled() const { return on_; }
  // In the order in which they were first timed.
  const std::vector<Stage>& stages() const { return stages_; }

  // Called once the queue has passed a stage, with its name; none: stages are not waited for.
  void tell(std::function<void(const char*)> listener) { listener_ = std::move(listener); }

  // Where stages that are captured from here on leave their events.
  void captureInto(StageMarks& marks) { marks_ = &marks; }

  // Runs launch() and adds its time to the stage of this name, at once or when what it marked is collected.
  template <class Launch>
  void time(Queue& queue, const char* name, const Launch& launch) {
#if GW_ON_CUDA
    nvtxRangePushA(name);
    struct Range {
      ~Range() { nvtxRangePop(); }
    } range;
#endif
    if (listener_) {
      launch();
      queue.synchronise();
      return listener_(name);
    }
    if (!on_) return launch();
    if (captured(queue, name, launch)) return;
    const auto begin = std::chrono::steady_clock::now();
    launch();
    queue.synchronise();
    const auto end = std::chrono::steady_clock::now();
    add(name, std::chrono::duration<double, std::milli>(end - begin).count());
  }

  // Once the tick that was captured into these marks has been replayed and waited for.
#if GW_ON_CUDA
  void collect(const StageMarks& marks) {
    for (const StageMarks::Span& span : marks.spans_) {
      float took_ms = 0;
      check(cudaEventElapsedTime(&took_ms, span.begin, span.end), "reading the time of a stage");
      add(span.stage.c_str(), took_ms);
    }
  }
#else
  void collect(const StageMarks&) {}
#endif

 private:
#if GW_ON_CUDA
  template <class Launch>
  bool captured(Queue& queue, const char* name, const Launch& launch) {
    cudaStreamCaptureStatus status = cudaStreamCaptureStatusNone;
    check(cudaStreamIsCapturing(queue.stream, &status), "asking whether the stream is captured");
    if (status == cudaStreamCaptureStatusNone) return false;
    const size_t own = marks_->spans_.size();
    marks_->spans_.push_back({name, nullptr, nullptr});
    StageMarks::place(queue, marks_->spans_[own].begin);
    launch();
    StageMarks::place(queue, marks_->spans_[own].end);
    return true;
  }
#else
  template <class Launch>
  bool captured(Queue&, const char*, const Launch&) {
    return false;
  }
#endif

  void add(const char* name, double took_ms) {
    for (Stage& stage : stages_) {
      if (stage.name != name) continue;
      stage.total_ms += took_ms;
      ++stage.calls;
      return;
    }
    stages_.push_back({name, took_ms, 1});
  }

  bool on_ = false;
  std::function<void(const char*)> listener_;
  std::vector<Stage> stages_;
  StageMarks* marks_ = nullptr;
};

}  // namespace gw::GW_DEVICE
