// What crowd_main.cpp sees of crowd.cu: the same function, once per device.
#pragma once

#include <gpuwars/exec_options.h>

#include <cstdint>

enum class Start { scattered, together };  // at random in the square; all in its centre

struct CrowdReport {
  uint64_t hash;                 // of all positions
  float closest_m, loneliest_m;  // the smallest and the largest distance from any walker to the nearest other
  float spreadX_m, spreadY_m;    // the standard deviation of places
};

struct CrowdRun {
  CrowdReport before, after;
};

namespace gw::cpu {
CrowdRun runCrowd(const ExecOptions& options, uint32_t agents, uint32_t steps, Start start);
}
#ifdef GW_HAVE_CUDA  // gw_add_kernels() defines it
namespace gw::cuda {
CrowdRun runCrowd(const ExecOptions& options, uint32_t agents, uint32_t steps, Start start);
}
#endif
