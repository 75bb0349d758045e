// Which code runs a kernel: that which was translated when the program was built, or the interpreter.
#pragma once

#include <memory>

#include "tests/ptx_machine/ptx/ptx_module.h"
#include "tests/ptx_machine/runtime/machine_options.h"

namespace gw::ptx {

class Interpreter;

// A module of the program, and what runs its kernels.
class LoadedModule {
 public:
  explicit LoadedModule(Module parsed);  // throws PtxError when no engine knows an instruction of it
  ~LoadedModule();

  const Kernel* kernel(std::string_view name) const;  // null: it has none of this name
  // Throws PtxError when the engine asked for has none.
  const Code& code(const Kernel& kernel, Engine engine);
  const Module& module() const { return module_; }

 private:
  Module module_;
  std::unique_ptr<Interpreter> interpreter_;  // made when the first kernel needs it
};

}  // namespace gw::ptx
