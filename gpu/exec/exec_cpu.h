// The execution layer on the cpu device. Not for users: include <gpuwars/exec.h>.
#pragma once

#include <gpuwars/exec_options.h>
#include <gpuwars/guarded_memory.h>
#include <gpuwars/worker_pool.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <new>

namespace gw::GW_DEVICE {

// Where launches go, in order. On cuda it is a stream, and launches return before they have run; here they run at once,
// on the calling thread and its pool. Used by one thread at a time. It outlives all that was made with it (see exec.h).
class Queue {
 public:
  // Starts the threads (on cuda makes the stream). Throws DeviceError on cuda when there is no device that answers.
  explicit Queue(const ExecOptions& options)
      : pool(options.threads), memory(options.protectMemory), order(options.order) {}

  // Waits until all launches and copies are done. On cuda a fault of any of them is thrown here, as DeviceError.
  void synchronise() {}

  WorkerPool pool;        // cpu only
  GuardedMemory memory;   // cpu only
  VisitOrder order;       // cpu only
  uint64_t launches = 0;  // so far
  size_t bytes = 0;       // in its buffers, now
};

// The i-th of n things to visit. Both factors are prime and larger than any n used with them, so the
// shuffle is a permutation.
inline uint32_t visit(VisitOrder order, uint32_t i, uint32_t n) {
  switch (order) {
    case VisitOrder::reversed:
      return n - 1 - i;
    case VisitOrder::shuffled:
      return uint32_t((uint64_t(i) * 4294967291u + 2654435761u) % n);
    default:
      return i;
  }
}

// The items of a launch: read on the device, at most the capacity.
inline uint32_t liveCount(const Count& count) {
  return count.d_live ? std::min(*count.d_live, count.capacity) : count.capacity;
}

// Items that a worker claims at a time. Enough to hide the claim; small enough to balance two workers.
inline constexpr uint32_t kChunk = 256;

// Runs kernel(0) ... kernel(n - 1), in any order and at once. The kernel is copied. Never throws on cpu.
template <class Kernel>
void forEach(Queue& queue, Count count, const Kernel& kernel) {
  ++queue.launches;
  GuardedMemory::Access access(queue.memory);
  struct Job {
    const Kernel& kernel;
    uint32_t n, chunks;
    VisitOrder order;
  } job{kernel, liveCount(count), 0, queue.order};
  job.chunks = (job.n + kChunk - 1) / kChunk;
  queue.pool.run(
      job.chunks,
      [](const void* context, uint32_t c) {
        const Job& mine = *static_cast<const Job*>(context);
        const uint32_t begin = visit(mine.order, c, mine.chunks) * kChunk, size = std::min(kChunk, mine.n - begin);
        const Kernel copy = mine.kernel;  // on this stack: the compiler can keep its fields in registers
        if (mine.order == VisitOrder::forward) {
          for (uint32_t i = begin; i < begin + size; ++i) copy(i);
        } else {
          for (uint32_t i = 0; i < size; ++i) copy(begin + visit(mine.order, i, size));
        }
      },
      &job);
}

// What the body of a team is called with.
template <uint32_t kLanes>
struct Team {
  uint32_t index;    // of the team
  VisitOrder order;  // of lanes, on cpu

  // Calls body(lane) for every lane; all are done when it returns.
  template <class Body>
  void phase(const Body& body) const {
    if (order == VisitOrder::forward) {
      for (uint32_t lane = 0; lane < kLanes; ++lane) body(lane);
    } else {
      for (uint32_t i = 0; i < kLanes; ++i) body(visit(order, i, kLanes));
    }
  }
};

// Runs kernel(team, shared) for the teams 0 .. teams - 1, in any order and at once. The kernel is copied.
template <class Kernel>
void forEachTeam(Queue& queue, uint32_t teams, const Kernel& kernel) {
  ++queue.launches;
  GuardedMemory::Access access(queue.memory);
  struct Job {
    const Kernel& kernel;
    uint32_t teams;
    VisitOrder order;
  } job{kernel, teams, queue.order};
  queue.pool.run(
      teams,
      [](const void* context, uint32_t t) {
        const Job& mine = *static_cast<const Job*>(context);
        const Kernel copy = mine.kernel;
        typename Kernel::Shared shared;
        copy(Team<Kernel::kLanes>{visit(mine.order, t, mine.teams), mine.order}, shared);
      },
      &job);
}

// Which way a copy goes.
enum class Copy { toDevice, toHost, onDevice };

// The one way in which bytes cross between host and device.
inline void copyBytes(Queue& queue, void* destination, const void* source, size_t bytes, Copy) {
  GuardedMemory::Access access(queue.memory);
  if (bytes) std::memcpy(destination, source, bytes);
}

// The same without waiting: a place in the queue, which a captured tick repeats.
inline void enqueueCopy(Queue& queue, void* destination, const void* source, size_t bytes, Copy kind) {
  copyBytes(queue, destination, source, bytes, kind);
}

// Device memory, zeroed. Throws DeviceOutOfMemory on cuda, std::runtime_error on cpu. Buffer owns such memory.
inline void* allocateBytes(Queue& queue, size_t bytes) {
  return queue.memory.allocate(bytes);
}
// Gives it back. Never throws.
inline void releaseBytes(Queue& queue, void* pointer) {
  queue.memory.release(pointer);
}

// Host memory that copies may read and write while the host works on: pinned on cuda. RecordRing owns such memory.
inline void* allocateHostBytes(Queue&, size_t bytes) {
  return ::operator new(bytes);
}
// Gives it back. Never throws.
inline void releaseHostBytes(Queue&, void* pointer) {
  ::operator delete(pointer);
}

// A place in the queue's work that the host can wait for; here all work is done when it has been launched.
class Fence {
 public:
  // Behind all that has been launched and copied so far.
  void place(Queue&) {}
  // Returns when the queue has passed it. Throws DeviceError on cuda when the work before it failed.
  void wait() {}
};

// Order-safe: integers only. They return nothing, so that no result can depend on who came first.
inline void atomicAddTo(uint32_t& word, uint32_t amount) {
  std::atomic_ref<uint32_t>(word).fetch_add(amount, std::memory_order_relaxed);
}

// Sets the word to the larger of both.
inline void atomicRaiseTo(uint64_t& word, uint64_t value) {
  std::atomic_ref<uint64_t> shared(word);
  uint64_t seen = shared.load(std::memory_order_relaxed);
  while (seen < value && !shared.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {
  }
}

// As atomicAddTo().
inline void atomicAddTo64(uint64_t& word, uint64_t amount) {
  std::atomic_ref<uint64_t>(word).fetch_add(amount, std::memory_order_relaxed);
}

}  // namespace gw::GW_DEVICE
