// Streams, events and graphs.
#include <chrono>
#include <utility>

#include "driver.h"

using namespace gw::stand_in;

namespace {

double now_ms() {
  using namespace std::chrono;
  return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

CUevent_st* eventOf(cudaEvent_t event) {
  return driver().events.count(event) ? event : nullptr;
}

}  // namespace

cudaError_t cudaStreamCreateWithFlags(cudaStream_t* stream, unsigned) {
  GW_ENTER("cudaStreamCreateWithFlags");
  driver().streams.insert(*stream = new CUstream_st);
  return cudaSuccess;
}

cudaError_t cudaStreamDestroy(cudaStream_t stream) {
  GW_ENTER("cudaStreamDestroy");
  if (driver().streams.erase(stream) == 0) return failed(cudaErrorInvalidResourceHandle);
  finish(*stream);
  for (CUevent_st* event : driver().events) {
    if (event->stream == stream) event->stream = nullptr;  // what it waited for is done
  }
  delete stream;
  return cudaSuccess;
}

cudaError_t cudaStreamSynchronize(cudaStream_t stream) {
  GW_ENTER_OUTSIDE_CAPTURE("cudaStreamSynchronize");
  CUstream_st* on = streamOf(stream);
  if (!on) return failed(cudaErrorInvalidResourceHandle);
  finish(*on);
  return outcomeOfWork();
}

cudaError_t cudaStreamWaitEvent(cudaStream_t stream, cudaEvent_t event, unsigned) {
  GW_ENTER("cudaStreamWaitEvent");
  CUstream_st* on = streamOf(stream);
  if (!on || !eventOf(event)) return failed(cudaErrorInvalidResourceHandle);
  if (event->stream == nullptr) return cudaSuccess;
  enqueue(*on, [other = event->stream, at = event->at] { finishUpTo(*other, at); });
  return cudaSuccess;
}

cudaError_t cudaStreamBeginCapture(cudaStream_t stream, cudaStreamCaptureMode) {
  GW_ENTER("cudaStreamBeginCapture");
  CUstream_st* on = streamOf(stream);
  if (!on || on == &driver().defaultStream || on->captured) return failed(cudaErrorInvalidResourceHandle);
  on->captured = new CUgraph_st;
  ++capturing;
  return cudaSuccess;
}

cudaError_t cudaStreamEndCapture(cudaStream_t stream, cudaGraph_t* graph) {
  GW_ENTER("cudaStreamEndCapture");
  CUstream_st* on = streamOf(stream);
  if (!on || !on->captured) return failed(cudaErrorInvalidResourceHandle);
  *graph = std::exchange(on->captured, nullptr);
  --capturing;
  return cudaSuccess;
}

cudaError_t cudaStreamIsCapturing(cudaStream_t stream, cudaStreamCaptureStatus* status) {
  GW_ENTER("cudaStreamIsCapturing");
  CUstream_st* on = streamOf(stream);
  if (!on) return failed(cudaErrorInvalidResourceHandle);
  *status = on->captured ? cudaStreamCaptureStatusActive : cudaStreamCaptureStatusNone;
  return cudaSuccess;
}

cudaError_t cudaEventCreateWithFlags(cudaEvent_t* event, unsigned flags) {
  GW_ENTER("cudaEventCreateWithFlags");
  driver().events.insert(*event = new CUevent_st);
  (*event)->timed = (flags & cudaEventDisableTiming) == 0;
  return cudaSuccess;
}

cudaError_t cudaEventCreate(cudaEvent_t* event) {
  return cudaEventCreateWithFlags(event, cudaEventDefault);
}

cudaError_t cudaEventRecordWithFlags(cudaEvent_t event, cudaStream_t stream, unsigned flags) {
  GW_ENTER("cudaEventRecord");
  CUstream_st* on = streamOf(stream);
  if (!on || !eventOf(event)) return failed(cudaErrorInvalidResourceHandle);
  const bool external = (flags & cudaEventRecordExternal) != 0;
  if (external && !on->captured) return failed(cudaErrorInvalidValue);
  // Captured without the flag it would order nodes of the graph, and say nothing to the host.
  if (on->captured && !external) return failed(cudaErrorStreamCaptureUnsupported);
  enqueue(*on, [event] { event->happened_ms = now_ms(); });
  if (!external) {
    event->stream = on;
    event->at = on->enqueued;
  }
  return cudaSuccess;
}

cudaError_t cudaEventRecord(cudaEvent_t event, cudaStream_t stream) {
  return cudaEventRecordWithFlags(event, stream, cudaEventRecordDefault);
}

cudaError_t cudaEventSynchronize(cudaEvent_t event) {
  GW_ENTER_OUTSIDE_CAPTURE("cudaEventSynchronize");
  if (!eventOf(event)) return failed(cudaErrorInvalidResourceHandle);
  if (event->stream) finishUpTo(*event->stream, event->at);
  return outcomeOfWork();
}

cudaError_t cudaEventQuery(cudaEvent_t event) {
  GW_ENTER("cudaEventQuery");
  if (!eventOf(event)) return failed(cudaErrorInvalidResourceHandle);
  return !event->stream || event->stream->done >= event->at ? cudaSuccess : cudaErrorNotReady;
}

cudaError_t cudaEventElapsedTime(float* ms, cudaEvent_t begin, cudaEvent_t end) {
  GW_ENTER("cudaEventElapsedTime");
  if (!eventOf(begin) || !eventOf(end) || !begin->timed || !end->timed) return failed(cudaErrorInvalidResourceHandle);
  if (begin->happened_ms == 0 || end->happened_ms == 0) return failed(cudaErrorNotReady);
  *ms = float(end->happened_ms - begin->happened_ms);
  return cudaSuccess;
}

cudaError_t cudaEventDestroy(cudaEvent_t event) {
  GW_ENTER("cudaEventDestroy");
  if (!eventOf(event)) return failed(cudaErrorInvalidResourceHandle);
  finishAll();  // work that is still queued may set it
  driver().events.erase(event);
  delete event;
  return cudaSuccess;
}

cudaError_t cudaGraphInstantiate(cudaGraphExec_t* executable, cudaGraph_t graph, unsigned long long) {
  GW_ENTER("cudaGraphInstantiate");
  *executable = new CUgraphExec_st{graph->nodes};
  return cudaSuccess;
}

cudaError_t cudaGraphLaunch(cudaGraphExec_t executable, cudaStream_t stream) {
  GW_ENTER("cudaGraphLaunch");
  CUstream_st* on = streamOf(stream);
  if (!on) return failed(cudaErrorInvalidResourceHandle);
  for (const Work& node : executable->nodes) enqueue(*on, node);
  return cudaSuccess;
}

cudaError_t cudaGraphUpload(cudaGraphExec_t, cudaStream_t) {
  GW_ENTER("cudaGraphUpload");
  return cudaSuccess;
}

cudaError_t cudaGraphDestroy(cudaGraph_t graph) {
  GW_ENTER("cudaGraphDestroy");
  delete graph;
  return cudaSuccess;
}

cudaError_t cudaGraphExecDestroy(cudaGraphExec_t executable) {
  GW_ENTER("cudaGraphExecDestroy");
  delete executable;
  return cudaSuccess;
}
