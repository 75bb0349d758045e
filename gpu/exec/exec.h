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
#pragma once

#include <gpuwars/device.h>

#include <cstdint>

namespace gw::GW_DEVICE {

// How many items a launch covers: the capacity is known on the host and fixes the grid, so that a launch
// can be captured once; the live count is read on the device.
struct Count {
  uint32_t capacity = 0;
  const uint32_t* d_live = nullptr;  // null: all of them
};

}  // namespace gw::GW_DEVICE

#if GW_ON_CUDA
#include <gpuwars/detail/exec_cuda.h>
#else
#include <gpuwars/detail/exec_cpu.h>
#endif
