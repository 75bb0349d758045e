// The execution layer: how kernels are launched on either device.
//
//   struct Scale {                                   // one item: one number
//     float* out; const float* in;
//     GW_BODY void operator()(uint32_t i) const { out[i] = 2.0f * in[i]; }
//   };
//   forEach(queue, Count{n}, Scale{out, in});
//
//   struct Reverse {                                 // one team: one line of kLanes numbers
//     static constexpr uint32_t kLanes = 128;
//     struct Shared { float line[kLanes]; };         // __shared__ on cuda, a stack object on cpu
//     float* lines;
//     template <class Team> GW_BODY void operator()(const Team& team, Shared& s) const {
//       float* line = lines + team.index * kLanes;
//       team.phase([&](uint32_t lane) { s.line[lane] = line[lane]; });
//       team.phase([&](uint32_t lane) { line[lane] = s.line[kLanes - 1 - lane]; });
//     }
//   };
//   forEachTeam(queue, teams, Reverse{lines});
//
// A phase runs once per lane: on cuda it ends in __syncthreads(), on cpu it is a loop. Between phases the
// code is the same for all lanes and never returns. Launches on one queue run one after the other.
//
// Lifetimes: a Queue outlives every Buffer, RecordRing, TickGraph, Fence and NGrid made with it. A kernel is copied
// into its launch, so what it points to must last until the queue has passed it: on cuda until synchronise(), a
// download() or a waited-for Fence; on cpu a launch has ended when forEach() returns.
//
// Errors: what the device refuses is a DeviceError, no room a DeviceOutOfMemory (device_error.h), with one sentence. A
// kernel that fails on cuda shows at the next call that waits, or at its launch with ExecOptions::checkLaunches. After
// any error but DeviceOutOfMemory what was made with the queue can only be destroyed, which never throws.
#pragma once

#include <gpuwars/device.h>

#include <cstdint>

namespace gw::GW_DEVICE {

// How many items a launch covers: the capacity is known on the host and fixes the grid, so that a launch
// can be captured once; the live count is read on the device.
struct Count {
  uint32_t capacity = 0;             // items that the grid is made for
  const uint32_t* d_live = nullptr;  // null: all of them
};

}  // namespace gw::GW_DEVICE

#if GW_ON_CUDA
#include <gpuwars/detail/exec_cuda.h>
#else
#include <gpuwars/detail/exec_cpu.h>
#endif
