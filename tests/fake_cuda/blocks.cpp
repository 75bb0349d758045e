// Kernels: each block's threads are fibers, which run one at a time and change over at barriers only.
//
// A thread that meets no barrier needs no fiber of its own: one fiber runs thread after thread, until one waits. So a
// kernel without barriers costs a loop.
#include <boost/context/fiber.hpp>
#include <boost/context/protected_fixedsize_stack.hpp>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <memory>

#include "cuda_runtime.h"
#include "driver.h"

constinit thread_local uint3 threadIdx, blockIdx;
constinit thread_local dim3 blockDim, gridDim;

namespace gw::cuda {
// What gpu/exec/exec_cuda.h declares.
extern constinit thread_local unsigned char sharedBytes[];
alignas(128) constinit thread_local unsigned char sharedBytes[228 * 1024];
}  // namespace gw::cuda

namespace gw::stand_in {
namespace {

namespace context = boost::context;

constexpr size_t kStack_bytes = 256 * 1024;
constexpr unsigned kWarp = 32, kMostThreads = 1024;

// Stacks that begin at different cache lines of their pages: else those of a block fight for a few places in the cache.
class Stacks {
 public:
  explicit Stacks(size_t fiber) : shift_bytes_(fiber % 48 * 64) {}
  context::stack_context allocate() {
    context::stack_context stack = pages_.allocate();
    stack.sp = static_cast<char*>(stack.sp) - shift_bytes_;
    stack.size -= shift_bytes_;
    return stack;
  }
  void deallocate(context::stack_context&) {}  // fibers never end

 private:
  size_t shift_bytes_;
  context::protected_fixedsize_stack pages_{kStack_bytes};
};

struct Fiber {
  context::fiber rest;  // where it goes on, while another runs
  unsigned thread = 0;  // the one it runs
};

struct Warp {
  uint64_t words[2][kWarp];
  unsigned arrivals = 0;      // at the barrier under way, as a mask
  unsigned waitedFor = 0;     // by those that arrived
  unsigned exchanges[kWarp];  // so far, by lane
};

class Runner {
 public:
  void run(const std::function<void()>& thread, unsigned threads, bool reversed) {
    thread_ = &thread;
    threads_ = threads;
    reversed_ = reversed;
    started_ = exited_ = atBarrier_ = 0;
    vote_ = false;
    exitedMask_.assign((threads + kWarp - 1) / kWarp, 0u);
    warps_.assign(exitedMask_.size(), Warp{});
    while (exited_ < threads_) {
      if (!ready_.empty()) {
        yield();
      } else if (started_ < threads_) {
        go(*idleFiber());
      } else if (atBarrier_ > 0 && atBarrier_ == threads_ - exited_) {
        openBarrier();  // who has returned is not waited for
      } else if (!openSomeWarp()) {
        std::fprintf(stderr, "CUDA stand-in: %u of %u threads wait for ever in block %u.\n", threads_ - exited_,
                     threads_, blockIdx.x);
        std::abort();
      }
    }
  }

  void syncBlock() {
    if (atBarrier_ + 1 == threads_ - exited_ && started_ == threads_) {
      openBarrier();
      return;
    }
    ++atBarrier_;
    waiting_.push_back(current_);
    yield();
  }

  bool syncBlockOr(bool vote) {
    vote_ |= vote;
    syncBlock();
    return voted_;
  }

  void syncWarp(unsigned mask) {
    const unsigned own = threadIdx.x % kWarp;
    Warp& warp = warps_[threadIdx.x / kWarp];
    if ((mask >> own & 1u) == 0) {
      std::fprintf(stderr, "CUDA stand-in: thread %u waits with a mask that leaves it out.\n", threadIdx.x);
      std::abort();
    }
    warp.arrivals |= 1u << own;
    warp.waitedFor = mask & present(threadIdx.x / kWarp);
    if (open(threadIdx.x / kWarp)) return;
    inWarp_.push_back(current_);
    yield();
  }

  const uint64_t* exchange(unsigned mask, uint64_t word) {
    const unsigned own = threadIdx.x % kWarp;
    Warp& warp = warps_[threadIdx.x / kWarp];
    uint64_t* words = warp.words[warp.exchanges[own]++ % 2];
    words[own] = word;
    syncWarp(mask);
    return words;
  }

 private:
  unsigned present(unsigned warp) const {
    const unsigned lanes = threads_ - warp * kWarp;
    return lanes >= kWarp ? 0xFFFFFFFFu : (1u << lanes) - 1;
  }

  // Whether all who are waited for have come or gone; if so, those who waited go on.
  bool open(unsigned w) {
    Warp& warp = warps_[w];
    if (warp.arrivals == 0 || (warp.waitedFor & ~(warp.arrivals | exitedMask_[w])) != 0) return false;
    for (auto it = inWarp_.begin(); it != inWarp_.end();) {
      if ((*it)->thread / kWarp == w) {
        ready_.push_back(*it);
        it = inWarp_.erase(it);
      } else {
        ++it;
      }
    }
    warp.arrivals = 0;
    return true;
  }

  bool openSomeWarp() {
    for (unsigned w = 0; w < warps_.size(); ++w) {
      if (open(w)) return true;
    }
    return false;
  }

  void openBarrier() {
    for (Fiber* fiber : waiting_) ready_.push_back(fiber);
    waiting_.clear();
    atBarrier_ = 0;
    voted_ = vote_;  // until the next barrier opens, for which all have to read it first
    vote_ = false;
  }

  Fiber* idleFiber() {
    if (idle_.empty()) {
      fibers_.push_back(std::make_unique<Fiber>());
      Fiber* made = fibers_.back().get();
      made->rest = context::fiber(std::allocator_arg, Stacks(fibers_.size()), [this, made](context::fiber&& from) {
        left_->rest = std::move(from);
        for (;;) {
          runThreads(*made);
          idle_.push_back(made);
          yield();
        }
        return context::fiber{};
      });
      return made;
    }
    Fiber* fiber = idle_.back();
    idle_.pop_back();
    return fiber;
  }

  // On a fiber: threads that have not begun, one after the other.
  void runThreads(Fiber& self) {
    while (started_ < threads_) {
      const unsigned t = started_++;
      self.thread = reversed_ ? threads_ - 1 - t : t;
      threadIdx = {self.thread, 0, 0};
      (*thread_)();
      ++exited_;
      exitedMask_[self.thread / kWarp] |= 1u << self.thread % kWarp;
    }
  }

  void go(Fiber& next) {
    left_ = current_;
    current_ = &next;
    threadIdx = {next.thread, 0, 0};
    context::fiber from = std::move(next.rest).resume();
    left_->rest = std::move(from);  // of the fiber that came here
  }

  void yield() {
    if (ready_.empty()) return go(scheduler_);
    Fiber* next = ready_.front();
    ready_.pop_front();
    go(*next);
  }

  const std::function<void()>* thread_ = nullptr;
  unsigned threads_ = 0, started_ = 0, exited_ = 0, atBarrier_ = 0;
  bool reversed_ = false, vote_ = false, voted_ = false;
  Fiber scheduler_;
  Fiber *current_ = &scheduler_, *left_ = nullptr;
  std::vector<std::unique_ptr<Fiber>> fibers_;
  std::vector<Fiber*> idle_, waiting_, inWarp_;
  std::deque<Fiber*> ready_;
  std::vector<Warp> warps_;
  std::vector<unsigned> exitedMask_;
};

Runner& runner() {
  thread_local auto* made = new Runner;  // never destroyed: its fibers end nowhere
  return *made;
}

void runGrid(const cudaLaunchConfig_t& config, const std::function<void()>& thread, bool reversed) {
  ++driver().kernels;
  gridDim = config.gridDim;
  blockDim = config.blockDim;
  for (unsigned b = 0; b < config.gridDim.x; ++b) {
    blockIdx = {reversed ? config.gridDim.x - 1 - b : b, 0, 0};
    std::memset(gw::cuda::sharedBytes, 0xA5, config.dynamicSmemBytes);
    runner().run(thread, config.blockDim.x, reversed);
  }
}

}  // namespace

void syncBlock() {
  runner().syncBlock();
}
bool syncBlockOr(bool vote) {
  return runner().syncBlockOr(vote);
}
void syncWarp(unsigned mask) {
  runner().syncWarp(mask);
}
const uint64_t* exchange(unsigned mask, uint64_t word) {
  return runner().exchange(mask, word);
}

cudaError_t launch(const cudaLaunchConfig_t& config, const void* kernel, std::function<void()> thread) {
  GW_ENTER("cudaLaunchKernelEx");
  CUstream_st* on = streamOf(config.stream);
  if (!on) return failed(cudaErrorInvalidResourceHandle);
  const bool fits = config.gridDim.x > 0 && config.gridDim.y == 1 && config.gridDim.z == 1 && config.blockDim.x > 0 &&
                    config.blockDim.x <= kMostThreads && config.blockDim.y == 1 && config.blockDim.z == 1;
  if (!fits || config.dynamicSmemBytes > dynamicSharedLimit_bytes(kernel)) return failed(cudaErrorInvalidConfiguration);
  enqueue(*on, [config, thread = std::move(thread), reversed = driver().options.reversed] {
    runGrid(config, thread, reversed);
  });
  return cudaSuccess;
}

}  // namespace gw::stand_in

cudaError_t cudaFuncSetAttribute(const void* kernel, cudaFuncAttribute, int value) {
  GW_ENTER("cudaFuncSetAttribute");
  if (value > 227 * 1024) return gw::stand_in::failed(cudaErrorInvalidValue);
  gw::stand_in::driver().sharedLimits[kernel] = value;
  return cudaSuccess;
}

cudaError_t cudaFuncGetAttributes(cudaFuncAttributes* attributes, const void*) {
  GW_ENTER("cudaFuncGetAttributes");
  *attributes = {0, 0, int(gw::stand_in::kMostThreads), 32, 90, 90};
  return cudaSuccess;
}
