#include "tests/ptx_machine/runtime/engines.h"

#include <algorithm>

#include "tests/ptx_machine/interpreter/interpreter.h"

namespace gw::ptx {

LoadedModule::LoadedModule(Module parsed) : module_(std::move(parsed)) {}
LoadedModule::~LoadedModule() = default;

const Kernel* LoadedModule::kernel(std::string_view name) const {
  const auto found = std::find_if(module_.kernels.begin(), module_.kernels.end(),
                                  [&](const Kernel& kernel) { return kernel.name == name; });
  return found == module_.kernels.end() ? nullptr : &*found;
}

const Code& LoadedModule::code(const Kernel& kernel, Engine engine) {
  if (engine == Engine::translated)
    throw PtxError("The kernel " + kernel.name + " was not translated for this program.");
  if (!interpreter_) interpreter_ = std::make_unique<Interpreter>(module_);
  return interpreter_->code(kernel);
}

}  // namespace gw::ptx
