// One launch of a kernel on the machine, and what is found wrong in it.
#pragma once

#include "tests/fake_cuda/driver.h"
#include "tests/ptx_machine/runtime/registration.h"

namespace gw::ptx {

// `arguments` as cudaLaunchKernel has them: a pointer to each. They are copied now, the kernel runs when the work does.
stand_in::Work kernelWork(const LoadedKernel& kernel, Size3 grid, Size3 block, uint32_t dynamicShared_bytes,
                          void** arguments);

}  // namespace gw::ptx
