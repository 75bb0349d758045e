#include "tests/ptx_machine/runtime/registration.h"

#include <cuda_runtime_api.h>

#include <cstdio>
#include <map>

#include "tests/ptx_machine/ptx/fat_binary.h"
#include "tests/ptx_machine/runtime/engines.h"
#include "tests/ptx_machine/runtime/ptx_device.h"

namespace gw::ptx {

// What an object registers. Its module is read when it is first needed.
struct FatBinary {
  const void* wrapper = nullptr;
  std::unique_ptr<LoadedModule> module;
  std::string refusal;  // why it cannot be run; empty: not known to be so
};

namespace {

struct Registry {
  std::vector<std::unique_ptr<FatBinary>> binaries;
  std::map<const void*, std::unique_ptr<RegisteredKernel>> kernels;  // by stub
};

Registry& registry() {
  static auto* made = new Registry;  // objects register before main() and after it take leave
  return *made;
}

std::string nameOfModule(const FatBinary& binary) {
  for (const auto& [stub, kernel] : registry().kernels) {
    if (kernel->from == &binary) return "the PTX that holds " + kernel->name;
  }
  return "PTX without kernels";
}

LoadedModule& moduleOf(FatBinary& binary) {
  if (!binary.refusal.empty()) throw PtxError(binary.refusal);
  if (binary.module) return *binary.module;
  try {
    const std::vector<EmbeddedPtx> texts = embeddedPtx(binary.wrapper);
    if (texts.size() != 1) {
      throw PtxError("An object holds " + std::to_string(texts.size()) +
                     " modules of PTX, and the machine runs one: compile for one virtual architecture.");
    }
    binary.module = std::make_unique<LoadedModule>(parsePtx(texts.front().text, nameOfModule(binary)));
  } catch (const PtxError& error) {
    binary.refusal = error.what();
    throw;
  }
  return *binary.module;
}

}  // namespace

RegisteredKernel* registeredKernel(const void* stub) {
  const auto found = registry().kernels.find(stub);
  return found == registry().kernels.end() ? nullptr : found->second.get();
}

const LoadedKernel* load(RegisteredKernel& kernel) {
  if (kernel.loaded) return kernel.loaded.get();
  try {
    LoadedModule& module = moduleOf(*kernel.from);
    const Kernel* text = module.kernel(kernel.name);
    if (!text) throw PtxError(module.module().name + " has no kernel " + kernel.name + ".");
    kernel.loaded = std::make_unique<LoadedKernel>(
        LoadedKernel{kernel.stub, text, &module.code(*text, device().options.engine), &module.module()});
  } catch (const PtxError& error) {
    std::fprintf(stderr, "PTX machine: %s\n", error.what());
    return nullptr;
  }
  return kernel.loaded.get();
}

}  // namespace gw::ptx

using namespace gw::ptx;

extern "C" {

void** __cudaRegisterFatBinary(void* wrapper) {
  registry().binaries.push_back(std::make_unique<FatBinary>());
  registry().binaries.back()->wrapper = wrapper;
  return reinterpret_cast<void**>(registry().binaries.back().get());
}

void __cudaRegisterFatBinaryEnd(void**) {}
// Destructors of others may launch until the very end.
void __cudaUnregisterFatBinary(void**) {}
char __cudaInitModule(void**) {
  return 1;
}

void __cudaRegisterFunction(void** binary, const char* stub, char*, const char* name, int, uint3*, uint3*, dim3*, dim3*,
                            int*) {
  auto kernel = std::make_unique<RegisteredKernel>();
  kernel->stub = stub;
  kernel->name = name;
  kernel->from = reinterpret_cast<FatBinary*>(binary);
  registry().kernels[stub] = std::move(kernel);
}

// Kernels find the variables of their module by themselves; no host code here reads or writes one by its name.
void __cudaRegisterVar(void**, char*, char*, const char*, int, size_t, int, int) {}

}  // extern "C"
