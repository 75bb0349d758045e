// What the PTX machine is told by the environment. GW_PTX_MACHINE is a list, with commas, of
//   engine=interpreter      instruction by instruction, lane by lane: slow, and the oracle
//   engine=translated       only code that was translated when the program was built (default: it where there is any)
//   order=ascending         blocks, and the warps of a block, in this order (default), ...
//   order=reversed          ... in the opposite one ...
//   order=shuffled          ... or in one that differs from launch to launch, by
//   seed=N                  this seed (1). CUB's kernels run in ascending order whatever is asked for: blocks look back
//   unchecked               no access is checked
//   races=off               all checks but that of races
//   stop-at-fault           the launch in which something is found wrong fails, and every call after it
// and of what tests/fake_cuda/stand_in.h lists for both builds: eager, apart, fault=CALL:N:E.
//
// What is found wrong is printed to stderr once, in full, when the launch ends; the program goes on, as far as it can,
// and ends with a summary and exit status 3 if it would have ended with 0.
#pragma once

#include <string>

#include "tests/ptx_machine/machine/warp.h"

namespace gw::ptx {

constexpr int kFaultsFoundStatus = 3;

enum class Engine : uint8_t { any, interpreter, translated };

struct MachineOptions {
  Engine engine = Engine::any;
  Options machine{};
  bool stopAtFault = false;
};

// False: the option is not known, or its value is not.
bool takeMachineOption(MachineOptions& options, const std::string& option);

}  // namespace gw::ptx
