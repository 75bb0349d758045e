// The cpu device's threads: a persistent pool that runs numbered chunks. Which thread runs which chunk is
// never decided in advance; chunk borders do not depend on the number of threads.
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace gw {

// Its threads begin with it and end with it.
class WorkerPool {
 public:
  // threads counts the caller too; 0 takes one per processor that this process may use. At most 256.
  explicit WorkerPool(uint32_t threads);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  // One chunk of a run.
  using Chunk = void (*)(const void* context, uint32_t chunk);

  // Runs chunk(context, 0 .. chunks-1), each exactly once, and returns when all are done. The caller
  // works too. Not reentrant: one run at a time, from one thread.
  void run(uint32_t chunks, Chunk chunk, const void* context);

  // Workers stop spinning and sleep until the next run: call before handing the cores to a GL driver.
  void park() { spin_.store(false, std::memory_order_relaxed); }

  // The caller counts too.
  uint32_t threads() const { return uint32_t(workers_.size()) + 1; }

 private:
  void work();
  bool claimAndRun(uint32_t generation);

  // Generation in the high half, chunks not yet claimed in the low half. A worker that wakes late finds
  // another generation and leaves, so run() never has to wait for sleepers.
  std::atomic<uint64_t> state_{0};
  std::atomic<uint32_t> done_{0};
  std::atomic<uint32_t> wake_{0};  // what sleepers wait on; equals the generation
  std::atomic<bool> spin_{true};
  std::atomic<bool> stop_{false};
  uint32_t chunks_ = 0;
  Chunk chunk_ = nullptr;
  const void* context_ = nullptr;
  std::vector<std::thread> workers_;
};

}  // namespace gw
