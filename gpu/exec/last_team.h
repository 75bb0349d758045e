// Last-block pattern: the last team to arrive runs the epilogue in the same launch.
//
//   team 0   writes its rows ── arrives (1 of 3), ends
//   team 1   writes its rows ── arrives (3 of 3), reads all rows, writes what is known of them together
//   team 2   writes its rows ── arrives (2 of 3), ends
//
// Which team that is changes from run to run, what it finds and writes does not: no result depends on it. Saves a
// launch, which costs more than what a single team has left to do.
#pragma once

#include <gpuwars/exec.h>

#if !GW_ON_CUDA
#include <atomic>
#endif

namespace gw::GW_DEVICE {

// Called by all lanes of each of `teams` teams once: true in the last of them, and what the others have written before
// is seen there. *d_arrived is 0 before a launch and is left so. On cpu teams have one lane.
template <class Team>
GW_BODY bool isLastTeam(const Team&, uint32_t& s_isLast, uint32_t* d_arrived, uint32_t teams) {
#if GW_ON_CUDA
  __syncthreads();  // the team has written
  if (threadIdx.x == 0) {
    __threadfence();  // ... and a team that sees the arrival sees those writes
    s_isLast = atomicAdd(d_arrived, 1u) == teams - 1;
    if (s_isLast) *d_arrived = 0;
    __threadfence();
  }
  __syncthreads();
  return s_isLast;
#else
  std::atomic_ref<uint32_t> arrived(*d_arrived);
  s_isLast = arrived.fetch_add(1, std::memory_order_acq_rel) == teams - 1;
  if (s_isLast) arrived.store(0, std::memory_order_relaxed);
  return s_isLast;
#endif
}

}  // namespace gw::GW_DEVICE
