// What nvcc's objects register before main(): fat binaries, and kernels by the address of their host stub. A module is
// read, and a kernel prepared for an engine, when it is first launched or asked for.
#pragma once

#include <memory>
#include <string>

#include "tests/ptx_machine/machine/warp.h"
#include "tests/ptx_machine/ptx/ptx_module.h"

namespace gw::ptx {

struct FatBinary;

struct LoadedKernel {
  const void* stub = nullptr;
  const Kernel* text = nullptr;
  const Code* code = nullptr;
  const Module* module = nullptr;
};

// What a cudaKernel_t points to.
struct RegisteredKernel {
  const void* stub = nullptr;
  std::string name;  // mangled
  FatBinary* from = nullptr;
  std::unique_ptr<LoadedKernel> loaded;
};

// Null: no kernel has this stub.
RegisteredKernel* registeredKernel(const void* stub);
// Null when the PTX cannot be run; one sentence on stderr has said why.
const LoadedKernel* load(RegisteredKernel& kernel);

}  // namespace gw::ptx
