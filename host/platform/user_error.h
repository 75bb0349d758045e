// What a user can do something about: one sentence with a remedy, and the exit code that goes with it.
#pragma once

#include <stdexcept>
#include <string>

#include "host/platform/exit_code.h"

namespace gw {

struct UserError : std::runtime_error {
  UserError(ExitCode exitCode, const std::string& sentence) : std::runtime_error(sentence), code(exitCode) {}
  ExitCode code;
};

}  // namespace gw
