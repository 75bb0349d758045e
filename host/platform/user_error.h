// The base of all errors that a user can correct: one sentence with a remedy, and the exit code of the program.
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
