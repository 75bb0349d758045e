// What the parts of the stand-in share: one driver, one lock around it.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "device_seam.h"
#include "stand_in.h"

struct cudaGraphicsResource;

namespace gw::stand_in {

using Work = std::function<void()>;

}  // namespace gw::stand_in

struct CUgraph_st {
  std::vector<gw::stand_in::Work> nodes;
};
struct CUgraphExec_st {
  std::vector<gw::stand_in::Work> nodes;
};

struct CUstream_st {
  std::deque<gw::stand_in::Work> queued;
  uint64_t enqueued = 0, done = 0;
  CUgraph_st* captured = nullptr;
};

struct CUevent_st {
  CUstream_st* stream = nullptr;  // where it was recorded last; null: nowhere
  uint64_t at = 0;                // done when so much of it is
  bool timed = true;
  double happened_ms = 0;
};

namespace gw::stand_in {

struct Block {
  void* mapped;
  size_t mapped_bytes;
  size_t bytes;
  bool pinned;
};

struct Driver {
  Options options;
  uint64_t calls = 0, kernels = 0;
  std::map<std::string, uint64_t> byName;
  std::vector<std::string> log;
  std::string struck;
  cudaError_t sticky = cudaSuccess, last = cudaSuccess;
  std::map<uintptr_t, Block> blocks;
  std::set<CUstream_st*> streams;
  std::set<CUevent_st*> events;
  std::set<cudaGraphicsResource*> resources;  // OpenGL's buffers that are registered; gl_interop.cpp's own
  std::map<const void*, int> sharedLimits;    // by kernel: what it was granted
  CUstream_st defaultStream;
};

std::recursive_mutex& lock();
Driver& driver();
extern thread_local unsigned capturing;  // streams, by this thread

// Counts a call, and says whether it is to fail: every call begins with this.
cudaError_t entering(const char* call);
// The same, for calls that must not be made while a stream is captured.
cudaError_t enteringOutsideCapture(const char* call);
cudaError_t failed(cudaError_t error);

// Null for a stream that is none.
CUstream_st* streamOf(cudaStream_t stream);
void enqueue(CUstream_st& stream, Work work);
void finish(CUstream_st& stream);
void finishUpTo(CUstream_st& stream, uint64_t work);
void finishAll();

// Memory of the host that ends at a page that must not be touched: pinned, or the stand-in's device memory.
constexpr unsigned char kNeverWritten = 0xA5;
void* allocateGuarded(size_t bytes, bool pinned);
bool releaseGuarded(void* pointer, bool pinned);
const Block* guardedBlock(const void* pointer);  // that it points into; null: none
bool isPinned(const void* pointer);
void loseMemory();

// A kernel failed while it ran: a sticky error, which the call that waits for it returns.
void deviceFailed(cudaError_t error);
cudaError_t outcomeOfWork();
// What a kernel was granted of shared memory by cudaFuncSetAttribute, or what it has without asking.
size_t dynamicSharedLimit_bytes(const void* kernel);

}  // namespace gw::stand_in

#define GW_ENTER(call)                                                      \
  const std::lock_guard<std::recursive_mutex> locked(gw::stand_in::lock()); \
  if (const cudaError_t refused = gw::stand_in::entering(call); refused != cudaSuccess) return refused
#define GW_ENTER_OUTSIDE_CAPTURE(call)                                      \
  const std::lock_guard<std::recursive_mutex> locked(gw::stand_in::lock()); \
  if (const cudaError_t refused = gw::stand_in::enteringOutsideCapture(call); refused != cudaSuccess) return refused
