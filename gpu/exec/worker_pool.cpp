#include <gpuwars/float_state.h>
#include <gpuwars/processors.h>
#include <gpuwars/worker_pool.h>

#include <algorithm>

#if defined(__SSE__)
#include <immintrin.h>
#endif

namespace gw {
namespace {

// Long enough to bridge the gap between two launches of one tick, short enough that an idle pool costs
// nothing that a person would notice (about 40 us on current processors).
constexpr int kSpins = 2000;

void relax() {
#if defined(__SSE__)
  _mm_pause();
#else
  std::this_thread::yield();
#endif
}

}  // namespace

WorkerPool::WorkerPool(uint32_t threads) {
  if (threads == 0) threads = readProcessors().usable();
  threads = std::min(threads, 256u);
  workers_.reserve(threads - 1);
  for (uint32_t i = 1; i < threads; ++i) workers_.emplace_back([this] { work(); });
}

WorkerPool::~WorkerPool() {
  stop_.store(true);
  wake_.fetch_add(1);
  wake_.notify_all();
  for (auto& worker : workers_) worker.join();
}

bool WorkerPool::claimAndRun(uint32_t generation) {
  uint64_t state = state_.load(std::memory_order_acquire);
  while (true) {
    if (uint32_t(state >> 32) != generation || uint32_t(state) == 0) return false;
    if (state_.compare_exchange_weak(state, state - 1, std::memory_order_acq_rel, std::memory_order_acquire)) break;
  }
  // The claim keeps this generation alive until done_ is raised, so the job's fields are stable here.
  chunk_(context_, chunks_ - uint32_t(state));
  done_.fetch_add(1, std::memory_order_acq_rel);
  return true;
}

void WorkerPool::run(uint32_t chunks, Chunk chunk, const void* context) {
  if (chunks == 0) return;
  setFloatState();
  if (workers_.empty() || chunks == 1) {
    for (uint32_t c = 0; c < chunks; ++c) chunk(context, c);
    return;
  }
  chunks_ = chunks;
  chunk_ = chunk;
  context_ = context;
  done_.store(0, std::memory_order_relaxed);
  const uint32_t generation = uint32_t(state_.load(std::memory_order_relaxed) >> 32) + 1;
  spin_.store(true, std::memory_order_relaxed);
  state_.store(uint64_t(generation) << 32 | chunks, std::memory_order_release);
  wake_.store(generation, std::memory_order_release);
  wake_.notify_all();

  while (claimAndRun(generation)) {
  }
  for (int spins = 0; done_.load(std::memory_order_acquire) != chunks; ++spins) {
    // A worker that holds the last chunk may have lost its core: give ours up rather than starve it.
    if (spins < kSpins) {
      relax();
    } else {
      std::this_thread::yield();
    }
  }
}

void WorkerPool::work() {
  uint32_t seen = 0;
  while (true) {
    uint32_t now = wake_.load(std::memory_order_acquire);
    for (int spins = 0; now == seen && spins < kSpins && spin_.load(std::memory_order_relaxed); ++spins) {
      relax();
      now = wake_.load(std::memory_order_acquire);
    }
    if (now == seen) {
      wake_.wait(seen, std::memory_order_acquire);
      continue;
    }
    if (stop_.load()) return;
    seen = now;
    setFloatState();
    while (claimAndRun(seen)) {
    }
  }
}

}  // namespace gw
