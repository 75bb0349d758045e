// How fast bytes move: the ceiling of whatever only reads and writes memory.
#pragma once

#include <cstddef>

#include "gpu/exec/exec_options.h"

namespace gw::bench {

struct CopySpeeds {  // GB/s; a copy within the device reads and writes, and counts once
  double toDevice = 0, toHost = 0, onDevice = 0;
};

}  // namespace gw::bench

namespace gw::cpu {
bench::CopySpeeds copySpeeds(const ExecOptions& options, size_t bytes, unsigned rounds);
}
#ifdef GW_HAVE_CUDA
namespace gw::cuda {
bench::CopySpeeds copySpeeds(const ExecOptions& options, size_t bytes, unsigned rounds);
}
#endif
